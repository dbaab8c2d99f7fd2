// Counters that tests and users read to see what was shared out. Since the process started.
#pragma once

#include <atomic>
#include <cstdint>

struct dxStepStatistics {
    std::atomic<unsigned> parallelSteps{0};
    std::atomic<unsigned> parallelIslands{0};
    std::atomic<unsigned> teamSteps{0};
    std::atomic<unsigned> maxWorkersUsed{0};
    std::atomic<unsigned> parallelCollisions{0};
    std::atomic<unsigned> sharedCollisions{0};
    std::atomic<unsigned> contactsAhead{0};        // pairs
    std::atomic<unsigned> contactsAheadUnused{0};

    static dxStepStatistics &instance() {
        static dxStepStatistics statistics;
        return statistics;
    }

    void countParallelStep(unsigned islands, unsigned workers) {
        parallelSteps.fetch_add(1, std::memory_order_relaxed);
        parallelIslands.fetch_add(islands, std::memory_order_relaxed);
        noteWorkers(workers);
    }

    // Only where two workers at least took part.
    void countTeamStep(unsigned workers) {
        if (workers < 2) return;
        teamSteps.fetch_add(1, std::memory_order_relaxed);
        noteWorkers(workers);
    }

    // Likewise.
    void countParallelCollision(unsigned workers) {
        if (workers < 2) return;
        parallelCollisions.fetch_add(1, std::memory_order_relaxed);
        noteWorkers(workers);
    }

    // `computed` pairs were collided ahead of their callbacks, `used` of them asked for.
    void countSharedCollision(unsigned workers, std::uint64_t computed, std::uint64_t used) {
        if (workers > 1) sharedCollisions.fetch_add(1, std::memory_order_relaxed);
        contactsAhead.fetch_add(static_cast<unsigned>(computed), std::memory_order_relaxed);
        contactsAheadUnused.fetch_add(static_cast<unsigned>(computed - used), std::memory_order_relaxed);
    }

private:
    void noteWorkers(unsigned workers) {
        unsigned most = maxWorkersUsed.load(std::memory_order_relaxed);
        while (most < workers &&
               !maxWorkersUsed.compare_exchange_weak(most, workers, std::memory_order_relaxed)) {
        }
    }
};
