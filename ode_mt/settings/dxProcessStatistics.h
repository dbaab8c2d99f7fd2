// Counters of parallel steps and collisions since the process started. All getters of ode_MT.h read them (dODE_MT_Statistics). dxWorldStatistics has
// those of one world.
//
// Threading: any thread may count and read. Each number is consistent in itself.
#pragma once

#include <atomic>
#include <cstdint>

#include <ode/ode_MT.h>

struct dxProcessStatistics {
    using Count = std::atomic<std::uint64_t>;  // a crowd has a million pairs in a second; 32 bits would overflow in an hour

    std::atomic<unsigned> maxWorkersUsed{0};
    Count parallelSteps{0};
    Count parallelIslands{0};
    Count teamSteps{0};
    Count parallelCollisions{0};
    Count sharedCollisions{0};
    Count contactsAhead{0};  // pairs
    Count contactsAheadUnused{0};
    Count directIslands{0};
    Count directFallbacks{0};  // of these, solved by Dantzig's algorithm or regularised

    static dxProcessStatistics &instance() {
        static dxProcessStatistics statistics;
        return statistics;
    }

    // Returns the counters that programs know.
    dODE_MT_Statistics read() const {
        dODE_MT_Statistics counted{};
        counted.parallelSteps = parallelSteps;
        counted.parallelIslands = parallelIslands;
        counted.teamSteps = teamSteps;
        counted.parallelCollisions = parallelCollisions;
        counted.sharedCollisions = sharedCollisions;
        counted.contactsAhead = contactsAhead;
        counted.contactsAheadUnused = contactsAheadUnused;
        return counted;
    }

    void countParallelStep(unsigned islands, unsigned workers) {
        parallelSteps.fetch_add(1, std::memory_order_relaxed);
        parallelIslands.fetch_add(islands, std::memory_order_relaxed);
        noteWorkers(workers);
    }

    // Counts a step only if at least two workers took part.
    void countLargeIslandStep(unsigned workers) {
        if (workers < 2) return;
        teamSteps.fetch_add(1, std::memory_order_relaxed);
        noteWorkers(workers);
    }

    // Counts a collision only if at least two workers took part.
    void countParallelCollision(unsigned workers) {
        if (workers < 2) return;
        parallelCollisions.fetch_add(1, std::memory_order_relaxed);
        noteWorkers(workers);
    }

    // `computed`: number of pairs whose contacts were prefetched; `used`: of these, asked for by callbacks.
    void countSharedCollision(unsigned workers, std::uint64_t computed, std::uint64_t used) {
        if (workers > 1) sharedCollisions.fetch_add(1, std::memory_order_relaxed);
        contactsAhead.fetch_add(computed, std::memory_order_relaxed);
        contactsAheadUnused.fetch_add(computed - used, std::memory_order_relaxed);
    }

private:
    void noteWorkers(unsigned workers) {
        unsigned most = maxWorkersUsed.load(std::memory_order_relaxed);
        while (most < workers &&
               !maxWorkersUsed.compare_exchange_weak(most, workers, std::memory_order_relaxed)) {
        }
    }
};
