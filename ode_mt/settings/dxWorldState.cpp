#include "settings/dxWorldState.h"

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "core/dxCacheLine.h"
#include "core/dxMixedBits.h"
#include "threading/process/dxProcess.h"

namespace {

// Worlds and their states: a hash table with a fixed number of places, and a map for the worlds that find no free one. A place is searched without a
// lock: as long as a world exists, nobody changes the place that holds it.
class Table {
public:
    dxWorldState *find(const dxWorld *world) {
        if (m_count.load(std::memory_order_acquire) == 0) return nullptr;
        const Bucket &bucket = bucketOf(world);
        for (std::size_t i = 0; i < kPlaces; ++i)
            if (bucket.worlds[i].load(std::memory_order_acquire) == world) return bucket.states[i];
        if (m_othersCount.load(std::memory_order_acquire) == 0) return nullptr;
        const std::lock_guard<dxForkSafeMutex> hold(mutex);
        return findOther(world);
    }

    // Keeps `state` unless another thread was faster; returns the one that is kept. Throws std::bad_alloc, and changes nothing then.
    dxWorldState &keep(const dxWorld *world, std::unique_ptr<dxWorldState> state) {
        const std::lock_guard<dxForkSafeMutex> hold(mutex);
        Bucket &bucket = bucketOf(world);
        std::size_t free = kPlaces;
        for (std::size_t i = 0; i < kPlaces; ++i) {
            const dxWorld *const there = bucket.worlds[i].load(std::memory_order_relaxed);
            if (there == world) return *bucket.states[i];
            if (there == nullptr) free = i;
        }
        if (dxWorldState *const other = findOther(world)) return *other;
        dxWorldState &kept = *state;
        if (free < kPlaces) {
            bucket.states[free] = state.release();
            bucket.worlds[free].store(world, std::memory_order_release);
        } else {
            m_others.emplace(world, std::move(state));
            m_othersCount.store(m_others.size(), std::memory_order_release);
        }
        m_count.fetch_add(1, std::memory_order_release);
        return kept;
    }

    std::unique_ptr<dxWorldState> remove(const dxWorld *world) {
        if (m_count.load(std::memory_order_acquire) == 0) return nullptr;
        const std::lock_guard<dxForkSafeMutex> hold(mutex);
        std::unique_ptr<dxWorldState> state = take(world);
        if (state != nullptr) m_count.fetch_sub(1, std::memory_order_release);
        return state;
    }

    template <class Visit>
    void forAll(const Visit &visit) {
        if (m_count.load(std::memory_order_acquire) == 0) return;
        const std::lock_guard<dxForkSafeMutex> hold(mutex);
        for (Bucket &bucket : m_buckets)
            for (std::size_t i = 0; i < kPlaces; ++i)
                if (bucket.worlds[i].load(std::memory_order_relaxed) != nullptr) visit(*bucket.states[i]);
        for (const auto &other : m_others) visit(*other.second);
    }

    // What fast solvers keep is freed; what a world has of its own stays.
    void atClose() {
        forAll([](dxWorldState &state) { state.fastQuickStep.reset(); });
    }
    void atUnload() { atClose(); }

    dxForkSafeMutex mutex;

private:
    static constexpr unsigned kBucketBits = 7;
    static constexpr std::size_t kPlaces = 8;  // the worlds of a bucket are in one cache line

    struct alignas(kCacheLine) Bucket {
        std::atomic<const dxWorld *> worlds[kPlaces] = {};  // null: free
        dxWorldState *states[kPlaces] = {};
    };

    Bucket &bucketOf(const dxWorld *world) {
        return m_buckets[dxMixedBits(reinterpret_cast<std::uintptr_t>(world)) >> (64 - kBucketBits)];
    }

    dxWorldState *findOther(const dxWorld *world) const {
        const auto found = m_others.find(world);
        return found != m_others.end() ? found->second.get() : nullptr;
    }

    std::unique_ptr<dxWorldState> take(const dxWorld *world) {
        Bucket &bucket = bucketOf(world);
        for (std::size_t i = 0; i < kPlaces; ++i) {
            if (bucket.worlds[i].load(std::memory_order_relaxed) != world) continue;
            bucket.worlds[i].store(nullptr, std::memory_order_release);
            return std::unique_ptr<dxWorldState>(std::exchange(bucket.states[i], nullptr));
        }
        const auto found = m_others.find(world);
        if (found == m_others.end()) return nullptr;
        std::unique_ptr<dxWorldState> state = std::move(found->second);
        m_others.erase(found);
        if (m_others.empty()) decltype(m_others)().swap(m_others);  // what is kept would be lost with an unloading
        m_othersCount.store(m_others.size(), std::memory_order_release);
        return state;
    }

    Bucket m_buckets[std::size_t(1) << kBucketBits];
    std::unordered_map<const dxWorld *, std::unique_ptr<dxWorldState>> m_others;
    std::atomic<std::size_t> m_othersCount{0};
    std::atomic<std::size_t> m_count{0};
};

dxProcessObject<Table> table;

}  // namespace

dxWorldState *dxWorldState::find(const dxWorld *world) { return table->find(world); }

dxWorldState &dxWorldState::of(const dxWorld *world) {
    if (dxWorldState *const state = table->find(world)) return *state;
    return table->keep(world, std::make_unique<dxWorldState>());
}

// The state ends outside of the lock.
void dxWorldState::forget(const dxWorld *world) { table->remove(world).reset(); }

dxForkSafeMutex &dxWorldState::lock() { return table->mutex; }

void dxWorldState::forAllStates(void (*visit)(dxWorldState &, const void *), const void *visiting) {
    table->forAll([visit, visiting](dxWorldState &state) { visit(state, visiting); });
}

dxWorldState::dxWorldState() {
    const dxSolverChoice &ofProcess = dxSettings::instance().solver();
    m_solver = ofProcess.solver;
    m_tolerance = ofProcess.tolerance;
    m_isWarm = ofProcess.isWarm;
}

dxSolverChoice dxWorldState::solver() const {
    return {m_solver.load(std::memory_order_relaxed), m_tolerance.load(std::memory_order_relaxed), m_isWarm.load(std::memory_order_relaxed)};
}

dxWorldSettings dxWorldSettings::of(const dxWorld *world) {
    const dxWorldState *const state = dxWorldState::find(world);
    if (state == nullptr) return {dxSettings::instance().solver()};
    return {state->solver(), state->threads.own(), state->solvingLimit.load(std::memory_order_relaxed)};
}

bool dxSetSolver(const dxWorld *world, const std::string &name) {
    dxSolver solver = dxSolver::Exact;
    if (!dxSettings::readSolver(name, solver)) return false;
    dxWorldState::of(world).setSolver(solver);
    return true;
}

void dxSetThreads(const dxWorld *world, unsigned threads) {
    dxWorldState *const state = threads != 0 ? &dxWorldState::of(world) : dxWorldState::find(world);
    if (state != nullptr) state->threads.choose(threads);
}

void dxSetSolvingLimit(const dxWorld *world, unsigned threads) {
    const bool isUnlimited = threads == dWORLDSTEP_THREADCOUNT_UNLIMITED;
    dxWorldState *const state = isUnlimited ? dxWorldState::find(world) : &dxWorldState::of(world);
    if (state != nullptr) state->solvingLimit.store(threads, std::memory_order_relaxed);
}
