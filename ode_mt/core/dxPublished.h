// A value that one thread at a time writes and any thread reads. Who reads it also sees what was written before it.
#pragma once

#include <atomic>

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
