// The runs in progress, where idle workers find something to join: a board of slots, each with one run, its blocks, its seats for workers, and the
// barrier at its end.
//
// The board holds up to 64 runs that use workers at one time, nested ones included. The caller of a run beyond that does it alone, which changes no
// result. There is no lock: a run is published by a bit in m_open.
//
// Forward progress: a thread waits only for blocks that another running thread holds, and that thread waits, if at all, only for blocks of runs
// nested in its own block. So waiting has no cycles, and no worker ever has to come.
//
// Source of the barrier: thesis section 4.1 (ode_barrier_t). There every thread waits for every other.
//
// Threading: any thread runs jobs, any worker joins them.
#pragma once

#include <atomic>
#include <cstdint>

#include "core/dxCacheLine.h"
#include "threading/dxFloatEnvironment.h"
#include "threading/dxThreadManager.h"
#include "threading/pool/dxFutex.h"

// The barrier at which the caller of a run waits for blocks that other threads hold. Only the caller waits, and only for blocks that were taken. The
// barrier counts blocks, not threads, so a worker that never arrived, or that was descheduled between two blocks, delays no other thread.
//
// The object outlives its runs (it lies in a slot), because the thread that finishes the last block still looks at m_isSleeping after the caller may
// have gone on. At worst it then wakes the caller of the next run for nothing.
class dxBarrier {
public:
    void reset(unsigned blocks);

    // Reports blocks as finished; everything written before is visible after wait().
    void arrive(unsigned blocks);

    // Returns when all blocks have arrived: spins for kLastBlocksTime, then sleeps.
    void wait();

private:
    dxFutexWord m_pending{0};
    std::atomic<bool> m_isSleeping{false};
};

// One run in progress. A slot is used for one run after another and is never freed while a worker may look at it. m_blocksLeft and m_seats have the
// number of the run (its generation) in the upper half, so that a worker that was descheduled between two steps of an old run can take neither a
// block nor a seat of a new one.
//
// Invariants
//  - A thread that holds a block keeps the run open: m_order may be read without further care.
//  - A thread that holds no block is never waited for, whether it has a seat or not.
//  - Blocks are handed out in ascending order: block = blocks - (blocks left before taking).
//  - A seat is given once per run: worker numbers 1 .. seats are unique within it, 0 is the caller.
//
// The generation has 32 bits. To be fooled, a worker would have to stand still between loading and exchanging one word for a multiple of 2^32 runs on
// this slot, which is hours of nothing but empty runs.
class alignas(kCacheLine) dxJobSlot {
public:
    struct Order {
        unsigned blocks;
        unsigned seats;  // places for workers beside the caller
        dxThreadManager::Task task;
        void *context;
    };

    // The caller's side, in this order. runAsCaller returns when no block is left to take.
    void open(const Order &order);
    void runAsCaller();
    void finish();

    // The worker's side. canJoin only looks; runAsWorker takes a seat, and blocks while there are any. It calls `joined` when it holds its first
    // block, so that the run cannot end during that call.
    bool canJoin() const;
    template <typename Joined>
    bool runAsWorker(Joined joined) {
        Seat seat;
        std::uint32_t left;
        if (!takeSeat(seat) || !takeBlock(seat.generation, left)) return false;
        joined();
        work(seat, left);
        return true;
    }

    // Forgets the run; for a forked child, where no worker exists.
    void abandon();

private:
    struct Seat {
        std::uint32_t generation;
        std::uint32_t left;  // seats left before this one was taken
    };

    bool takeSeat(Seat &seat);
    void work(Seat seat, std::uint32_t left);
    bool takeBlock(std::uint32_t generation, std::uint32_t &left);

    alignas(kCacheLine) std::atomic<std::uint64_t> m_blocksLeft{0};  // generation, blocks left
    std::atomic<std::uint64_t> m_seats{0};                           // generation, seats left
    alignas(kCacheLine) dxBarrier m_barrier;
    alignas(kCacheLine) Order m_order{};
    std::uint32_t m_generation = 0;  // the caller's
    unsigned m_takenByCaller = 0;
    dxFloatEnvironment m_environment;
};

// Sends workers to the board.
class dxWorkerSource {
public:
    // Called when a run has been published that can use `wanted` workers beside its caller.
    virtual void requestWorkers(unsigned wanted) = 0;

protected:
    ~dxWorkerSource() = default;
};

class dxJobBoard {
public:
    // Does a whole run, with up to `order.seats` workers beside the caller.
    void run(const dxJobSlot::Order &order, dxWorkerSource &source);

    // Returns whether there is a run with blocks and seats left, for a worker. Pairs with the publishing of a run: see dxParking.
    bool hasWork() { return find() != nullptr; }

    // Joins one run, if there is one, and works for it to its end. `joined` as in dxJobSlot.
    template <typename Joined>
    bool work(Joined joined) {
        dxJobSlot *slot = find();
        return slot != nullptr && slot->runAsWorker(joined);
    }

    // Forgets all runs (forked child).
    void abandon();

private:
    static constexpr unsigned kSlots = 64;

    // The end of a run, by whatever way its caller leaves it.
    struct Completion {
        dxJobBoard &board;
        const unsigned index;
        ~Completion();
    };

    dxJobSlot *find();
    unsigned acquire();
    void release(unsigned slot);

    dxJobSlot m_slots[kSlots];
    alignas(kCacheLine) std::atomic<std::uint64_t> m_open{0};  // slots that workers should look at
    alignas(kCacheLine) std::atomic<std::uint64_t> m_used{0};  // slots that belong to a caller
};

// Runs all blocks on the calling thread.
void dxRunAlone(unsigned blocks, dxThreadManager::Task task, void *context);
