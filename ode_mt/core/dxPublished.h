// Atomic values that publish: a thread that reads one also sees what was written before it.
#pragma once

#include <atomic>
#include <cstdint>

// A value that one thread at a time writes and any thread reads.
template <class Value>
class dxPublished {
public:
    explicit dxPublished(Value value) : m_value(value) {}

    operator Value() const { return m_value.load(std::memory_order_acquire); }
    dxPublished &operator=(Value value) {
        m_value.store(value, std::memory_order_release);
        return *this;
    }
    dxPublished(const dxPublished &) = delete;
    dxPublished &operator=(const dxPublished &) = delete;

private:
    std::atomic<Value> m_value;
};

// Counts events of the process. Code that keeps something compares counts to know whether there were any since. Any thread may add and read.
class dxEventCounter {
public:
    std::uint64_t count() const { return m_events.load(std::memory_order_acquire); }
    void add() { m_events.fetch_add(1, std::memory_order_acq_rel); }

private:
    std::atomic<std::uint64_t> m_events{0};
};
