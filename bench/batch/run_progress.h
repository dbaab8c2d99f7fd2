// One line on standard error that says how many runs are done and how long the rest takes: drawn anew in its place on a terminal, a new line
// every few seconds elsewhere.
#pragma once

#include <chrono>
#include <cstddef>

namespace batch {

class RunProgress {
public:
    RunProgress(long runs, long doneBefore, bool isQuiet);

    void show(std::size_t more);  // runs that have ended since
    void end();

private:
    using Clock = std::chrono::steady_clock;

    void print(const char *end) const;

    const long m_runs;
    const bool m_isQuiet, m_isTerminal;
    long m_done, m_doneBefore;
    const Clock::time_point m_begin = Clock::now();
    Clock::time_point m_next = m_begin;
};

}  // namespace batch
