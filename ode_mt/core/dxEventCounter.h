// Counts events of the process, so that whoever keeps something can see whether there were any since.
//
// Threading: any thread. What happened before an event is visible to whoever has seen its count.
#pragma once

#include <atomic>
#include <cstdint>

class dxEventCounter {
public:
    std::uint64_t count() const { return m_events.load(std::memory_order_acquire); }
    void add() { m_events.fetch_add(1, std::memory_order_acq_rel); }

private:
    std::atomic<std::uint64_t> m_events{0};
};
