// Counters of parallel work since the process started: the one place where it is counted for the process. All getters of ode_MT.h read it
// (dODE_MT_Statistics). What is counted of one world is in dxWorldStatistics.
//
// Threading: any thread may count and read; each number by itself is whole.
#pragma once

#include <atomic>
#include <cstdint>

#include <ode/ode_MT.h>

struct dxStepStatistics {
    using Count = std::atomic<std::uint64_t>;  // a crowd has a million pairs in a second, which 32 bits hold for an hour

    std::atomic<unsigned> maxWorkersUsed{0};
    Count parallelSteps{0};
    Count parallelIslands{0};
    Count teamSteps{0};
    Count parallelCollisions{0};
    Count sharedCollisions{0};
    Count contactsAhead{0};  // pairs
    Count contactsAheadUnused{0};
    Count directIslands{0};
    Count directFallbacks{0};  // of those, left to Dantzig's algorithm or regularised

    static dxStepStatistics &instance() {
        static dxStepStatistics statistics;
        return statistics;
    }

    // Of the members of which programs know.
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

    // `computed` pairs were collided ahead of their callbacks, `used` of them asked for.
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
