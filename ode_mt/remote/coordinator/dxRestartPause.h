// When a worker that was lost may be replaced: after a pause, which doubles with each worker that is lost before it has proved itself, so that one
// that cannot live costs less and less.
//
// Units: ns of one clock.
#pragma once

#include <algorithm>

class dxRestartPause {
public:
    // The worker of the link is lost, or its successor could not be started. `hasProved`: it has answered often.
    void begin(double now, bool hasProved) {
        m_pauseNs = hasProved ? kFirstNs : std::clamp(2 * m_pauseNs, kFirstNs, kMaxNs);
        m_end = now + m_pauseNs;
    }

    bool isOver(double now) const { return now >= m_end; }

private:
    static constexpr double kFirstNs = 100e6, kMaxNs = 60e9;

    double m_pauseNs = 0, m_end = 0;
};
