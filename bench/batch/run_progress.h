// How many runs are done, and how long the rest takes.
#pragma once

#include "progress_line.h"

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

    double elapsed() const;  // s

    const long m_runs;
    const bool m_isQuiet;
    long m_done, m_doneBefore;
    const Clock::time_point m_begin = Clock::now();
    bench::ProgressLine m_line;
};

}  // namespace batch
