// Lends workers to the engine. The engine owns the partition of work: it cuts a job into blocks
// whose results do not depend on the threads that run them. A manager only decides which thread runs which block.
//
// Source: thesis chapters 3 and 4 (thread manager; OpenMP against pthread). The thesis gives every worker a fixed share
// and waits for all of them at a barrier. Here blocks are assigned one by one in ascending order and the caller works
// too, so a worker that is not scheduled delays no other thread: the caller takes its blocks.
//
// Threading: any thread.
#pragma once

class dxThreadManager {
public:
    // Runs one block. `worker` is below the `maxWorkers` of the run and no two threads hold the same
    // number at one time within one run; 0 is the caller. Must not throw. May end its thread (pthread_exit), which
    // does not affect the run's other blocks.
    using Task = void (*)(void *context, unsigned block, unsigned worker);

    virtual ~dxThreadManager() = default;

    virtual const char *name() const = 0;

    // Returns an upper bound for `maxWorkers`, the caller included; at least 1.
    virtual unsigned workers() const = 0;

    // Sets the number of workers, 1 to 1024, the caller included. Idle threads are started or joined
    // here or on first use. Where the system refuses a thread, there are fewer; that is reported once.
    virtual void resize(unsigned workers) = 0;

    // Calls task(context, b, worker) once for every b in [0, blocks) and returns when all calls have
    // returned; their writes are then visible to the caller. The blocks start in ascending order.
    // Any number of threads may call run at once, also from inside a task: such a run gets those
    // workers that are idle, and its caller does the rest. Workers take over the caller's
    // floating-point environment. No allocation in steady state.
    virtual void run(unsigned blocks, unsigned maxWorkers, Task task, void *context) = 0;

    // Ends all idle threads (dCloseODE, unloading); the next run starts them again.
    virtual void stop() = 0;
};
