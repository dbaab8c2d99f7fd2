// The barrier at which the caller of a run waits for blocks that other threads hold.
//
// Source: thesis section 4.1 (ode_barrier_t). There every thread waits for every other; here only the caller waits, and
// only for blocks that were taken: the barrier counts blocks, not threads, so a worker that never arrived, or that was
// descheduled between two blocks, delays no other thread.
//
// The object outlives its runs (it lies in a slot of the job board), because the thread that finishes
// the last block still looks at `sleeping` after the caller may have gone on. It then at worst wakes the
// caller of the next run for nothing.
#pragma once

#include "threading/pool/dxFutex.h"

class dxBarrier {
public:
    void reset(unsigned blocks);

    // Reports blocks as finished; everything written before is visible after wait().
    void arrive(unsigned blocks);

    // Returns when all blocks have arrived: spins for dxLastBlocksTime, then sleeps.
    void wait();

private:
    dxFutexWord pending{0};
    std::atomic<bool> sleeping{false};
};
