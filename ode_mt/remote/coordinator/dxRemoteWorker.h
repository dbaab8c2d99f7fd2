// One worker as the coordinator sees it: its link, the measurement of that, and when it may be replaced once it is lost.
//
// Units: ns of one clock. Threading: under the lock of dxRemoteWorkers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "remote/coordinator/dxRemoteLink.h"

// To be measured, a link carries small messages, and then large ones, one after the other; the fastest of each size counts.
class dxLinkMeasurement {
public:
    enum class Echo { Unexpected, Next, Last };

    // The next message: its number, its size (bytes), and when it is sent.
    std::uint64_t number() const { return m_count; }
    std::size_t size() const { return m_count < kSmall ? 0 : kLargeSize; }
    void begin(double now) { m_begin = now; }

    // The worker has sent the message of this number back.
    Echo end(std::uint64_t number, double now) {
        if (number != m_count) return Echo::Unexpected;
        double &fastest = m_count < kSmall ? m_smallNs : m_largeNs;
        const bool isFirst = m_count == 0 || m_count == kSmall;
        fastest = isFirst ? now - m_begin : std::min(fastest, now - m_begin);
        return ++m_count < kSmall + kLarge ? Echo::Next : Echo::Last;
    }

    double latencyNs() const { return m_smallNs; }
    double nsPerByte() const { return std::max(m_largeNs - m_smallNs, 0.0) / (2.0 * kLargeSize); }

private:
    static constexpr unsigned kSmall = 4, kLarge = 3;
    static constexpr std::size_t kLargeSize = std::size_t{256} << 10;  // bytes

    unsigned m_count = 0;  // that have come back
    double m_begin = 0, m_smallNs = 0, m_largeNs = 0;
};

// A lost worker is replaced after a pause, which doubles with each worker that is lost before it has proved itself, so that one that cannot live
// costs less and less.
class dxRestartPause {
public:
    // The worker is lost, or its successor could not be started. `hasProved`: it has answered often.
    void begin(double now, bool hasProved) {
        m_pauseNs = hasProved ? kFirstNs : std::clamp(2 * m_pauseNs, kFirstNs, kMaxNs);
        m_end = now + m_pauseNs;
    }

    bool isOver(double now) const { return now >= m_end; }

private:
    static constexpr double kFirstNs = 100e6, kMaxNs = 60e9;

    double m_pauseNs = 0, m_end = 0;
};

struct dxRemoteWorker {
    dxRemoteLink link;
    dxLinkMeasurement measurement;
    dxRestartPause restart;
    double since = 0;  // when it was started
    bool isReplacement = false;
    bool isRefused = false;
    bool isUnreachable = false;  // else one that is lost may live, and has to hear of this process: the end of a process may be that of its job

    bool isOpen() const { return link.state() == dxRemoteLink::State::Open; }
    bool isLost() const { return link.state() == dxRemoteLink::State::Lost; }
    bool isReplaceable() const { return isLost() && !isRefused; }

    // It has greeted and was measured, or never will.
    bool isSettled() const { return isOpen() || isLost(); }

    // Another process has been started in its place.
    void becomeReplacement(double now) {
        link = dxRemoteLink();
        measurement = dxLinkMeasurement();
        isUnreachable = false;
        since = now;
        isReplacement = true;
    }
};
