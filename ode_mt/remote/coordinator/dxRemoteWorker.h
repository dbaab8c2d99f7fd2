// One worker as the coordinator sees it: its link, the measurement of the link, and when it may be replaced after it is lost.
//
// Units: ns of one clock.
//
// Threading: under the lock of dxRemoteWorkers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "remote/coordinator/dxRemoteLink.h"

// Measures a link by small messages, and then large ones, one after the other; the fastest of each size counts.
class dxLinkMeasurement {
public:
    enum class Echo { Unexpected, Next, Last };

    // The next message: its number, its size (bytes), and when it is sent.
    std::uint64_t number() const { return m_count; }
    std::size_t size() const { return m_count < kSmall ? 0 : kLargeSize; }
    void begin(double now) { m_begin = now; }

    // Called when the worker has sent the message with this number back.
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

// The pause before a lost worker is replaced. It doubles with each worker that is lost before it has answered often, so that workers that cannot run
// cost less and less.
class dxRestartPause {
public:
    // Called when the worker is lost, or a new one could not be started. `hasProved`: it has answered often.
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
    bool isUnreachable = false;  // otherwise a lost worker may live, and needs signs of life: if it ends, its whole job may end

    bool isOpen() const { return link.state() == dxRemoteLink::State::Open; }
    bool isLost() const { return link.state() == dxRemoteLink::State::Lost; }
    bool isReplaceable() const { return isLost() && !isRefused; }

    // Returns whether it has said hello and was measured, or never will.
    bool isSettled() const { return isOpen() || isLost(); }

    // Called when another process has been started instead.
    void becomeReplacement(double now) {
        link = dxRemoteLink();
        measurement = dxLinkMeasurement();
        isUnreachable = false;
        since = now;
        isReplacement = true;
    }
};
