// Wall-clock time since it was made or restarted, of a clock that never goes back.
#pragma once

#include <chrono>

class dxStopwatch {
public:
    void restart() { m_start = Clock::now(); }
    double ns() const { return std::chrono::duration<double, std::nano>(Clock::now() - m_start).count(); }

private:
    using Clock = std::chrono::steady_clock;

    Clock::time_point m_start = Clock::now();
};
