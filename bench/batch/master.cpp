#include "batch/master.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>

#include "progress.h"
#include "tool_output.h"

namespace batch {

namespace {

std::string duration(double seconds) {
    const long whole = std::lround(seconds);
    char text[64];
    if (whole >= 3600)
        std::snprintf(text, sizeof text, "%ld h %02ld min", whole / 3600, whole / 60 % 60);
    else if (whole >= 60)
        std::snprintf(text, sizeof text, "%ld min %02ld s", whole / 60, whole % 60);
    else
        std::snprintf(text, sizeof text, "%ld s", whole);
    return text;
}

// How many runs are done, and how long the rest takes.
class RunProgress {
public:
    RunProgress(long runs, long doneBefore, bool isQuiet);

    void show(std::size_t more);  // runs that have ended since
    void end();

private:
    using Clock = std::chrono::steady_clock;

    double elapsed() const;  // s

    const long m_runs;
    const bool m_isQuiet;
    long m_done, m_doneBefore;
    const Clock::time_point m_begin = Clock::now();
    bench::ProgressLine m_line;
};

RunProgress::RunProgress(long runs, long doneBefore, bool isQuiet) : m_runs(runs), m_isQuiet(isQuiet), m_done(doneBefore), m_doneBefore(doneBefore) {}

double RunProgress::elapsed() const { return std::chrono::duration<double>(Clock::now() - m_begin).count(); }

void RunProgress::show(std::size_t more) {
    m_done += static_cast<long>(more);
    if (m_isQuiet || !m_line.isDue()) return;
    const double rate = static_cast<double>(m_done - m_doneBefore) / elapsed();
    char aSecond[32];
    std::snprintf(aSecond, sizeof aSecond, "%.1f", rate);
    m_line.show(std::to_string(m_done) + " of " + std::to_string(m_runs) + " runs, " + aSecond + " a second, " +
                (rate > 0 ? duration(static_cast<double>(m_runs - m_done) / rate) + " left" : "time left unknown"));
}

void RunProgress::end() {
    if (m_isQuiet) return;
    m_line.clear();
    std::fprintf(stderr, "%ld runs in %s\n", m_done - m_doneBefore, duration(elapsed()).c_str());
}

constexpr int kPollRanks = 2, kPollAlone = 200;  // ms
constexpr double kAhead = 0.1;                   // s of work that a site has at a time
constexpr double kWeight = 1.0 / 16;             // of a run in the moving average of their times

class Master {
public:
    Master(const Plan &plan, Store &store, Workers &workers, Ranks *ranks, bool isQuiet)
        : m_store(store), m_workers(workers), m_ranks(ranks), m_done(store.done()), m_progress(plan.count(), countDone(), isQuiet) {
        m_sites.push_back({workers.count(), 0});
        for (unsigned i = 0; ranks != nullptr && i < ranks->count(); ++i) m_sites.push_back({ranks->workers(i), 0});
        for (const Site &site : m_sites) m_allWorkers += site.workers;
        m_left = static_cast<std::size_t>(plan.count() - countDone());
    }

    void run() {
        while (m_left > 0 || outstanding() > 0) {
            for (std::size_t site = 0; site < m_sites.size(); ++site) fill(site);
            const std::vector<Json> answers = takeAnswers();
            m_store.write(answers);
            for (const Json &answer : answers) note(answer);
            m_progress.show(answers.size());
        }
        m_progress.end();
    }

private:
    struct Site {
        unsigned workers;
        std::size_t outstanding;
    };

    long countDone() const { return std::count(m_done.begin(), m_done.end(), true); }

    std::size_t outstanding() const {
        std::size_t all = 0;
        for (const Site &site : m_sites) all += site.outstanding;
        return all;
    }

    void fill(std::size_t index) {
        Site &site = m_sites[index];
        const double ahead = m_seconds > 0 ? std::min(kAhead / m_seconds, 1e4) : 1;
        const std::size_t byTime = std::max<std::size_t>(2, static_cast<std::size_t>(ahead));
        const std::size_t byRest = std::max<std::size_t>(1, m_left / (2 * m_allWorkers));
        const std::size_t wanted = site.workers * std::min(byTime, byRest);
        if (site.outstanding > wanted / 2) return;
        std::vector<long> runs;
        while (m_left > 0 && site.outstanding + runs.size() < wanted) runs.push_back(next());
        if (runs.empty()) return;
        site.outstanding += runs.size();
        if (index == 0)
            m_workers.give(runs);
        else
            m_ranks->give(static_cast<unsigned>(index - 1), runs);
    }

    long next() {
        while (m_done[m_next]) ++m_next;
        --m_left;
        return static_cast<long>(m_next++);
    }

    std::vector<Json> takeAnswers() {
        std::vector<Json> answers = m_workers.takeAnswers(m_ranks != nullptr ? kPollRanks : kPollAlone);
        for (Json &answer : answers) answer["rank"] = 0;
        m_sites[0].outstanding -= answers.size();
        if (m_ranks == nullptr) return answers;
        for (auto &[index, answer] : m_ranks->takeAnswers()) {
            answer["rank"] = index + 1;
            --m_sites[index + 1].outstanding;
            answers.push_back(std::move(answer));
        }
        return answers;
    }

    void note(const Json &answer) {
        const double seconds = answer.value("seconds", 0.0);
        m_seconds = m_seconds > 0 ? (1 - kWeight) * m_seconds + kWeight * seconds : seconds;
    }

    Store &m_store;
    Workers &m_workers;
    Ranks *const m_ranks;
    const std::vector<bool> m_done;  // before this call
    RunProgress m_progress;
    std::vector<Site> m_sites;  // the first is this process
    std::size_t m_allWorkers = 0;
    std::size_t m_next = 0, m_left = 0;
    double m_seconds = 0;  // of a run
};

}  // namespace

void runPlan(const Plan &plan, Store &store, Workers &workers, Ranks *ranks, bool isQuiet) {
    Master(plan, store, workers, ranks, isQuiet).run();
}

int exitCodeOf(const Store &store) {
    const Store::Failed failed = store.failed();
    if (failed.count == 0) return 0;
    bench::printError((failed.count == 1 ? "1 run has failed, run " : std::to_string(failed.count) + " runs have failed, the first of them run ") +
                      std::to_string(failed.first) + ": " + failed.message + " (column message of the rows whose status is error)");
    return 1;
}

}  // namespace batch
