// The runs in progress, where idle workers find something to join.
//
// Holds up to 64 runs that use workers at one time, nested ones included. A run beyond that is done by
// its caller alone, which changes no result. There is no lock: a run is published by a bit in `open`.
//
// Forward progress: a thread waits only for blocks that another running thread holds, and that thread
// waits, if at all, only for blocks of runs nested in its own block. So waiting has no cycles, and it
// needs no worker ever to come.
#pragma once

#include "threading/pool/dxJobSlot.h"

// Whoever can send workers to the board.
class dxWorkerSource {
public:
    // Called when a run has been published that can use `wanted` workers beside its caller.
    virtual void requestWorkers(unsigned wanted) = 0;

protected:
    ~dxWorkerSource() = default;
};

class dxJobBoard {
public:
    // A whole run with up to `seats` workers beside the caller.
    void run(const dxJobSlot::Order &order, dxWorkerSource &source);

    // A worker looks for a run with blocks and seats left. Pairs with the publishing of a run: see
    // dxParking.
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
    static constexpr unsigned slotCount = 64;

    // The end of a run, by whatever way its caller leaves it.
    struct Completion {
        dxJobBoard &board;
        const unsigned index;
        ~Completion();
    };

    dxJobSlot *find();
    unsigned acquire();
    void release(unsigned slot);

    dxJobSlot slots[slotCount];
    alignas(64) std::atomic<std::uint64_t> open{0};  // slots that workers should look at
    alignas(64) std::atomic<std::uint64_t> used{0};  // slots that belong to a caller
};

// All blocks on the calling thread.
void dxRunAlone(unsigned blocks, dxThreadManager::Task task, void *context);
