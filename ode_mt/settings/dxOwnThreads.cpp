#include "settings/dxOwnThreads.h"

#include <atomic>
#include <mutex>

#include "threading/process/dxFork.h"
#include "threading/process/dxProcess.h"

namespace dxOwnThreads {

namespace {

// For each number, counts the worlds and spaces that have it.
class Numbers {
public:
    void exchange(unsigned before, unsigned now) {
        if (before == now) return;
        const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
        if (before != 0) --m_owners[before];
        if (now != 0) ++m_owners[now];
        unsigned largest = dODE_MT_MAX_THREADS;
        while (largest != 0 && m_owners[largest] <= 0) --largest;
        m_largest.store(largest, std::memory_order_relaxed);
    }

    unsigned largest() const { return m_largest.load(std::memory_order_relaxed); }

private:
    dxForkSafeMutex m_mutex;
    int m_owners[dODE_MT_MAX_THREADS + 1] = {};  // by their number; below 0 for a moment if two threads change the number of one owner
    std::atomic<unsigned> m_largest{0};
};

dxProcessObject<Numbers> numbers;

}  // namespace

unsigned largest() { return numbers->largest(); }

void exchange(unsigned before, unsigned now) { numbers->exchange(before, now); }

}  // namespace dxOwnThreads
