#include "settings/dxOwnThreads.h"

#include <atomic>
#include <mutex>
#include <utility>

#include "threading/process/dxForkLocks.h"
#include "threading/process/dxPerWorld.h"
#include "threading/process/dxProcessObject.h"

namespace dxOwnThreads {

namespace {

// How many worlds and spaces have each number.
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
    int m_owners[dODE_MT_MAX_THREADS + 1] = {};  // by their number; below 0 for a moment, where two threads set one number
    std::atomic<unsigned> m_largest{0};
};

dxProcessObject<Numbers> numbers;
dxProcessObject<dxPerWorld<unsigned>> ofWorlds;
dxProcessObject<dxPerWorld<unsigned>> solvingLimits;

}  // namespace

unsigned of(const dxWorld *world) {
    unsigned own = 0;
    ofWorlds->visit(world, [&own](unsigned threads) { own = threads; });
    return own;
}

void choose(const dxWorld *world, unsigned threads) {
    unsigned before = 0;
    if (threads == 0)
        ofWorlds->forget(world, [&before](unsigned own) { before = own; });
    else
        ofWorlds->visitOrMake(world, [] { return 0u; }, [&before, threads](unsigned &own) { before = std::exchange(own, threads); });
    numbers->exchange(before, threads);
}

unsigned solvingLimit(const dxWorld *world) {
    unsigned limit = dWORLDSTEP_THREADCOUNT_UNLIMITED;
    solvingLimits->visit(world, [&limit](unsigned threads) { limit = threads; });
    return limit;
}

void limitSolving(const dxWorld *world, unsigned threads) {
    if (threads == dWORLDSTEP_THREADCOUNT_UNLIMITED)
        solvingLimits->forget(world);
    else
        solvingLimits->visitOrMake(world, [] { return 0u; }, [threads](unsigned &limit) { limit = threads; });
}

void forget(const dxWorld *world) {
    solvingLimits->forget(world);
    if (!ofWorlds->isEmpty()) choose(world, 0);
}

unsigned largest() { return numbers->largest(); }

void exchange(unsigned before, unsigned now) { numbers->exchange(before, now); }

}  // namespace dxOwnThreads
