#include "threading/pool/dxJobBoard.h"

#include "threading/dxSchedulePoints.h"

namespace {

std::uint64_t bit(unsigned slot) { return std::uint64_t{1} << slot; }

// The lowest set bit; `mask` must not be zero.
unsigned lowest(std::uint64_t mask) { return static_cast<unsigned>(__builtin_ctzll(mask)); }

}  // namespace

void dxRunAlone(unsigned blocks, dxThreadManager::Task task, void *context) {
    for (unsigned block = 0; block < blocks; ++block) {
        dxPerturb(dxSchedulePoint::RunAlone);
        task(context, block, 0);
    }
}

void dxJobBoard::run(const dxJobSlot::Order &order, dxWorkerSource &source) {
    const unsigned index = acquire();
    if (index == slotCount) {
        dxRunAlone(order.blocks, order.task, order.context);
        return;
    }
    const Completion completion{*this, index};
    slots[index].open(order);
    open.fetch_or(bit(index));
    source.requestWorkers(order.seats);
    slots[index].runAsCaller();
}

// The thread may be at its end, in a block of its own or where the system lets it be cancelled: the blocks that are left
// are run all the same, since the run's order is about to go with the thread's stack.
dxJobBoard::Completion::~Completion() {
    dxJobSlot &slot = board.slots[index];
    slot.runAsCaller();
    dxPerturb(dxSchedulePoint::CloseRun);
    board.open.fetch_and(~bit(index));
    slot.finish();
    board.release(index);
}

void dxJobBoard::abandon() {
    for (dxJobSlot &slot : slots) slot.abandon();
    open.store(0);
    used.store(0);
}

dxJobSlot *dxJobBoard::find() {
    for (std::uint64_t left = open.load(); left != 0; left &= left - 1) {
        dxJobSlot &slot = slots[lowest(left)];
        if (slot.canJoin()) return &slot;
    }
    return nullptr;
}

unsigned dxJobBoard::acquire() {
    std::uint64_t now = used.load(std::memory_order_relaxed);
    dxPerturb(dxSchedulePoint::ClaimSlot);
    do {
        if (~now == 0) return slotCount;
    } while (!used.compare_exchange_weak(now, now | (now + 1), std::memory_order_acquire,
                                         std::memory_order_relaxed));
    return lowest(~now);
}

void dxJobBoard::release(unsigned slot) { used.fetch_and(~bit(slot), std::memory_order_release); }
