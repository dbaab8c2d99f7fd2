// Plays the same frames on Debian's libode8 and on ODE_MT for a given time, and fails as soon as they differ in a bit, or
// at the end if memory has grown, a thread is left, or no second worker took part.
//
//   odemt_soak --seconds 7200
#include "player_process.h"
#include "town.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;

struct Options {
    double seconds = 120;
    std::uint64_t seed = 1;
    int threads = 3;
    std::string ours = ODE_MT_LIBRARY_DIR, stock = ODE_MT_STOCK_LIBRARY_DIR;
};

// Arenas, tables and caches grow to the largest frame that they have seen, which takes some days with all settings, and some more where workers
// are late. What is lost never stops growing: memory that has grown is given as many days again, so often at most.
constexpr std::size_t kMinDays = 20;
constexpr int kMaxDoublings = 2;
constexpr double kGrowth = 1.01;

class Soak {
public:
    explicit Soak(const Options &options)
        : m_options(options),
          m_stock(options.stock, options.seed, options.threads),
          m_ours(options.ours, options.seed, options.threads) {}

    void run() {
        const Clock::time_point begin = Clock::now();
        do playDay();
        while (m_days.size() < kMinDays || std::chrono::duration<double>(Clock::now() - begin).count() < m_options.seconds);
        std::string grown = whatHasGrown();
        for (int doubling = 0; doubling < kMaxDoublings && !grown.empty(); ++doubling) {
            std::printf("%s: as many days again\n", grown.c_str());
            for (std::size_t left = m_days.size(); left > 0; --left) playDay();
            grown = whatHasGrown();
        }
        if (!grown.empty()) throw std::runtime_error(grown);
        end();
    }

private:
    void playDay() {
        for (int block = 0; block < soak::Town::blocksOfADay(); ++block) playBlock();
        m_days.push_back(m_lastOfOurs);
        std::printf("day %zu: %llu frames, %zu bytes in use, %zu resident, %d threads\n", m_days.size(),
                    static_cast<unsigned long long>(m_lastOfOurs.frames), m_lastOfOurs.liveBytes, m_lastOfOurs.residentBytes,
                    m_lastOfOurs.threads);
        std::fflush(stdout);
    }

    void playBlock() {
        m_stock.askForBlock();
        m_ours.askForBlock();
        const soak::Block expected = m_stock.answer();
        m_lastOfOurs = m_ours.answer();
        if (expected.library == m_lastOfOurs.library) throw std::runtime_error("both play on " + expected.library);
        if (expected.hash != m_lastOfOurs.hash)
            throw std::runtime_error("they differ within " + std::to_string(expected.frames) + " frames of seed " +
                                     std::to_string(m_options.seed));
    }

    // Empty: nothing has. What is resident goes up and down with what the allocator gives back: the highest of the first half counts, and the
    // lowest of the last quarter. Memory that is lost is in all of them.
    std::string whatHasGrown() const {
        const std::string inUse = growthOf("bytes in use", &soak::Block::liveBytes);
        return inUse.empty() ? growthOf("resident bytes", &soak::Block::residentBytes) : inUse;
    }
    std::string growthOf(const char *what, std::size_t soak::Block::*bytes) const {
        std::size_t most = 0;
        for (std::size_t day = 0; day < m_days.size() / 2; ++day) most = std::max(most, m_days[day].*bytes);
        std::size_t least = m_days.back().*bytes;
        for (std::size_t day = m_days.size() - m_days.size() / 4; day < m_days.size(); ++day) least = std::min(least, m_days[day].*bytes);
        if (static_cast<double>(least) <= kGrowth * static_cast<double>(most)) return "";
        return std::string(what) + " have grown from " + std::to_string(most) + " to " + std::to_string(least);
    }

    void end() {
        m_stock.askForTheEnd();
        m_ours.askForTheEnd();
        const soak::Block expected = m_stock.answer(), left = m_ours.answer();
        m_stock.waitForExit();
        m_ours.waitForExit();
        std::printf("left on ODE_MT: %zu bytes in use, %d threads; on libode8: %zu bytes, %d threads\n", left.liveBytes,
                    left.threads, expected.liveBytes, expected.threads);
        if (left.threads != 1) throw std::runtime_error(std::to_string(left.threads - 1) + " threads are left");
        if (m_options.threads > 1 && left.workers < 2) throw std::runtime_error("no second worker took part");
        std::printf("%llu frames: the same bits\n", static_cast<unsigned long long>(left.frames));
    }

    const Options m_options;
    soak::PlayerProcess m_stock, m_ours;
    soak::Block m_lastOfOurs;
    std::vector<soak::Block> m_days;
};

}  // namespace

int main(int argc, char **argv) {
    Options options;
    CLI::App app("Plays the same frames on libode8 and on ODE_MT for a time, and compares.");
    app.add_option("--seconds", options.seconds, "begins no day after this time; there are twenty at least")->capture_default_str();
    app.add_option("--seed", options.seed, "of settings")->capture_default_str();
    app.add_option("--threads", options.threads, "most of ODE_MT's")->check(CLI::Range(0, 64))->capture_default_str();
    app.add_option("--ours", options.ours, "folder of ODE_MT's library")->capture_default_str();
    app.add_option("--stock", options.stock, "folder of Debian's library")->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    std::signal(SIGPIPE, SIG_IGN);
    try {
        Soak(options).run();
        return 0;
    } catch (const std::exception &error) {
        std::fprintf(stderr, "odemt_soak: %s\n", error.what());
        return 1;
    }
}
