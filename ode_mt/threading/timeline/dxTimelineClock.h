// The clock of the timeline, in ticks: of the processor's counter where it has a constant rate, or else nanoseconds.
//
// The system's clock takes 24 ns to read and waits for all instructions before (a fence): with it the events of a small robot's frame of
// 11 us made the frame 4 % longer. The counter takes 8 ns, but does not wait for earlier instructions, so times are inexact by some nanoseconds. The
// rate is measured when it is needed: between the start of the trace and the writing of its file.
//
// Threading: any thread.
#pragma once

#include <time.h>

#include <cstdint>

#if defined(__x86_64__)
#include <cpuid.h>
#include <x86intrin.h>
#endif

class dxTimelineClock {
public:
    static std::uint64_t ticks() {
#if defined(__x86_64__)
        if (__builtin_expect(s_hasCounter, 1)) return __rdtsc();
#endif
        return ns();
    }

    // Reads a clock that never goes back.
    static std::uint64_t ns() {
        timespec time;
        clock_gettime(CLOCK_MONOTONIC, &time);
        return static_cast<std::uint64_t>(time.tv_sec) * 1'000'000'000 + static_cast<std::uint64_t>(time.tv_nsec);
    }

private:
    static const bool s_hasCounter;  // of a constant rate; false until it is known
};

// Converts ticks since the moment of its construction.
class dxTimelineScale {
public:
    // Measures the rate from then until now.
    void measure() {
        const std::uint64_t ticks = dxTimelineClock::ticks() - m_startTicks, ns = dxTimelineClock::ns() - m_startNs;
        m_nsPerTick = ticks != 0 ? static_cast<double>(ns) / static_cast<double>(ticks) : 1;
    }

    // Units: ns since the start. Never decreases where ticks do not, so that events that lie within one another do in ns.
    std::uint64_t timeOf(std::uint64_t ticks) const {
        return isBefore(ticks) ? 0 : static_cast<std::uint64_t>(static_cast<double>(ticks - m_startTicks) * m_nsPerTick);
    }

    // Returns the length of a span. Units: ns.
    double nsOf(std::uint64_t ticks) const { return static_cast<double>(ticks) * m_nsPerTick; }

    bool isBefore(std::uint64_t ticks) const { return ticks < m_startTicks; }

private:
    std::uint64_t m_startTicks = dxTimelineClock::ticks(), m_startNs = dxTimelineClock::ns();
    double m_nsPerTick = 1;
};
