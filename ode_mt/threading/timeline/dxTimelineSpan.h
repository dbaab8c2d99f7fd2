// An event of the calling thread from here to the end of the scope, by whatever way that is left but longjmp, which leaves no event.
#pragma once

#include "threading/timeline/dxTimeline.h"

class dxTimelineSpan {
public:
    // Where it begins: now, or where this thread has begun or ended an event last, just before.
    enum class Begin { Now, Adjoining };

    explicit dxTimelineSpan(const dxTimelineEvent &event, bool isWanted = true, Begin begin = Begin::Now)
        : m_event(event), m_ring(isWanted ? dxTimeline::ofThisThread() : nullptr) {
        if (m_ring == nullptr) return;
        m_begin = begin == Begin::Now ? m_ring->readClock() : m_ring->lastReading();
        m_arguments = {};
    }
    ~dxTimelineSpan() {
        if (m_ring != nullptr) m_ring->add(m_event, m_begin, m_endsAdjoining ? m_ring->lastReading() : m_ring->readClock(), m_arguments);
    }
    dxTimelineSpan(const dxTimelineSpan &) = delete;
    dxTimelineSpan &operator=(const dxTimelineSpan &) = delete;

    dxTimelineRing *ring() const { return m_ring; }  // null: nothing is recorded
    void endAdjoining() { m_endsAdjoining = true; }  // where the last event within it has ended, just before
    void set(unsigned argument, std::uint64_t value) {
        if (m_ring != nullptr) m_arguments[argument] = value;
    }

private:
    const dxTimelineEvent &m_event;
    dxTimelineRing *const m_ring;
    bool m_endsAdjoining = false;
    std::uint64_t m_begin;  // is set, as the arguments are, if something is recorded
    dxTimelineRing::Arguments m_arguments;
};
