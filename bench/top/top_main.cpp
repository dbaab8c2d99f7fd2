// odemt_top: how the frames of an unchanged program go, while it runs.
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>

#include "tool_output.h"
#include "support/orphans.h"
#include "top/frame_board.h"
#include "top/frame_rates.h"
#include "top/frame_text.h"
#include "top/program.h"
#include "top/screen.h"
#include "support/deferred_signals.h"
#include "top/top_options.h"
#include "support/temporary_folder.h"

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using top::FrameBoard;
using top::FrameRates;
using top::Program;
using top::TopOptions;

constexpr int kNotStarted = 127;       // exit code, as of a shell
constexpr auto kKeyInterval = 100ms;   // between looks at signals, while keys are waited for

// Readings one after the other.
class Readings {
public:
    explicit Readings(const FrameBoard &board) : m_board(board) {}

    // Since the last one.
    std::vector<FrameRates> next() {
        std::vector<top::WorldFrames> worlds = m_board.read();
        const Clock::time_point now = Clock::now();
        const double seconds = std::chrono::duration<double>(now - m_time).count();
        std::vector<FrameRates> rates = top::ratesBetween(m_worlds, worlds, seconds);
        m_worlds = std::move(worlds);
        m_time = now;
        return rates;
    }

private:
    const FrameBoard &m_board;
    std::vector<top::WorldFrames> m_worlds;
    Clock::time_point m_time = Clock::now();
};

// Standard output, which may be closed or full: that is said once, and the program goes on.
class Output {
public:
    void print(const std::string &text) {
        if (!m_isOpen) return;
        try {
            bench::print(text);
        } catch (const std::exception &error) {
            m_isOpen = false;
            bench::printError(error.what());
        }
    }

private:
    bool m_isOpen = true;
};

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

std::string titleOf(const TopOptions &options, double seconds, const char *what) {
    char text[300];
    std::snprintf(text, sizeof text, "odemt_top: %.200s, %.1f s%s", options.command[0].c_str(), seconds, what);
    return text;
}

// A signal for us is the program's; returns whether it has ended.
bool passOn(Program &program, int signal) {
    if (signal != 0 && signal != SIGCHLD) program.askToEnd(signal);
    return program.hasEnded();
}

void watchOnScreen(const TopOptions &options, Program &program, const FrameBoard &board) {
    const Clock::time_point start = Clock::now();
    top::Screen screen;
    Readings readings(board);
    while (!program.hasEnded()) {
        const std::vector<FrameRates> rates = readings.next();
        for (const Clock::time_point next = Clock::now() + options.interval; Clock::now() < next && !passOn(program, support::waitForSignal(0ms));) {
            screen.show(titleOf(options, secondsSince(start), "   (q: end it)"), rates, program.output());
            const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(next - Clock::now());
            if (screen.readKey(std::clamp<std::chrono::milliseconds>(left, 1ms, kKeyInterval))) program.askToEnd(SIGINT);
        }
    }
}

void watchInText(const TopOptions &options, Program &program, const FrameBoard &board, Output &out) {
    const Clock::time_point start = Clock::now();
    Readings readings(board);
    Clock::time_point next = start + options.interval;
    while (!program.hasEnded()) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(next - Clock::now());
        if (passOn(program, support::waitForSignal(left))) break;
        if (Clock::now() < next) continue;
        next += options.interval;
        if (options.mode == top::Mode::Batch)
            out.print(titleOf(options, secondsSince(start), "") + '\n' + top::textOf(readings.next(), board.refused()) + '\n');
    }
}

// An empty file of our own making is nobody's loss.
void tellOfOutput(const TopOptions &options, const Program &program, Output &out) {
    if (program.output().empty()) return;
    std::error_code error;
    if (options.output.empty() && std::filesystem::file_size(program.output(), error) == 0)
        std::filesystem::remove(program.output(), error);
    else
        out.print("Output of the program: " + program.output() + '\n');
}

int run(const TopOptions &options) {
    const support::TemporaryFolder folder("odemt_top");
    const FrameBoard board(folder.path());
    const Clock::time_point start = Clock::now();
    Program program(options, folder, board);
    Output out;
    if (options.mode == top::Mode::Screen)
        watchOnScreen(options, program, board);
    else
        watchInText(options, program, board, out);
    if (!program.endRest()) bench::printError("not all processes that the program has started could be ended");
    out.print(titleOf(options, secondsSince(start), ", all frames on average") + '\n' +
              top::textOf(top::ratesOfAll(board.read()), board.refused()));
    tellOfOutput(options, program, out);
    return program.exitCode();
}

}  // namespace

int main(int argc, char **argv) {
    bench::keepStandardFiles();
    int exitCode = 0;
    const auto options = top::readTopOptions(argc, argv, exitCode);
    if (!options) return bench::exitCodeAfterOutput(exitCode);
    support::deferSignals();
    support::adoptOrphans();
    try {
        return run(*options);
    } catch (const std::exception &error) {
        bench::printError(error.what());
        return kNotStarted;
    }
}
