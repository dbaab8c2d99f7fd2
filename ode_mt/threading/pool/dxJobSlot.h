// One run in progress: its blocks, its worker places, and the barrier at its end.
//
// A slot is used for one run after another and is never freed while a worker may look at it. `supply`
// and `seats` carry the number of the run (its generation) in the upper half, so that a worker which
// was descheduled between two steps of an old run can neither take a block nor a seat of a new one.
//
// Invariants
//  - A thread that holds a block keeps the run open: `order` may be read without further care.
//  - A thread that holds no block is never waited for, whether it has a seat or not.
//  - Blocks are handed out in ascending order: block = blocks - (blocks left before taking).
//  - A seat is given once per run: worker numbers 1 .. seats are unique within it, 0 is the caller.
//
// The generation has 32 bits. To be fooled, a worker would have to stand still between loading and
// exchanging one word for a multiple of 2^32 runs on this slot, which is hours of nothing but empty runs.
#pragma once

#include <atomic>
#include <cstdint>

#include "threading/dxFloatEnvironment.h"
#include "threading/dxThreadManager.h"
#include "threading/pool/dxBarrier.h"

class alignas(64) dxJobSlot {
public:
    struct Order {
        unsigned blocks;
        unsigned seats;  // places for workers beside the caller
        dxThreadManager::Task task;
        void *context;
    };

    // Caller's side, in this order. runAsCaller returns when no block is left to take.
    void open(const Order &newOrder);
    void runAsCaller();
    void finish();

    // Worker's side. canJoin is a look only; runAsWorker takes a seat and blocks while there are any. It
    // calls `joined` when it holds its first block, so that the run cannot end during that call.
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

    alignas(64) std::atomic<std::uint64_t> blocksLeft{0};  // generation, blocks left
    std::atomic<std::uint64_t> seats{0};               // generation, seats left
    alignas(64) dxBarrier barrier;
    alignas(64) Order order{};
    std::uint32_t generation = 0;  // the caller's
    unsigned takenByCaller = 0;
    dxFloatEnvironment environment;
};
