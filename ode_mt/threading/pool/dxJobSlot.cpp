#include "threading/pool/dxJobSlot.h"

#include "threading/dxSchedulePoints.h"

namespace {

std::uint64_t join(std::uint32_t generation, std::uint32_t left) {
    return std::uint64_t{generation} << 32 | left;
}
std::uint32_t generationOf(std::uint64_t word) { return static_cast<std::uint32_t>(word >> 32); }
std::uint32_t leftOf(std::uint64_t word) { return static_cast<std::uint32_t>(word); }

// Takes one from `word` if it still belongs to the generation; `left` is the number before.
bool takeOne(std::atomic<std::uint64_t> &word, std::uint32_t generation, std::uint32_t &left) {
    std::uint64_t now = word.load(std::memory_order_relaxed);
    do {
        left = leftOf(now);
        if (generationOf(now) != generation || left == 0) return false;
    } while (!word.compare_exchange_weak(now, now - 1, std::memory_order_acq_rel, std::memory_order_relaxed));
    return true;
}

}  // namespace

void dxJobSlot::open(const Order &newOrder) {
    order = newOrder;
    takenByCaller = 0;
    environment.capture();
    barrier.reset(order.blocks);
    ++generation;
    seats.store(join(generation, order.seats), std::memory_order_release);
    dxPerturb(dxSchedulePoint::OpenRun);
    blocksLeft.store(join(generation, order.blocks), std::memory_order_release);
}

void dxJobSlot::runAsCaller() {
    std::uint32_t left;
    while (takeBlock(generation, left)) {
        ++takenByCaller;
        order.task(order.context, order.blocks - left, 0);
    }
}

void dxJobSlot::finish() {
    barrier.arrive(takenByCaller);
    barrier.wait();
    environment.raiseFlags();
}

bool dxJobSlot::canJoin() const {
    const std::uint64_t blocks = blocksLeft.load(std::memory_order_acquire);
    if (leftOf(blocks) == 0) return false;
    const std::uint64_t free = seats.load(std::memory_order_relaxed);
    return generationOf(free) == generationOf(blocks) && leftOf(free) > 0;
}

void dxJobSlot::abandon() {
    blocksLeft.store(join(generation, 0));
    seats.store(join(generation, 0));
    barrier.reset(0);
}

bool dxJobSlot::takeSeat(Seat &seat) {
    const std::uint64_t blocks = blocksLeft.load(std::memory_order_acquire);
    if (leftOf(blocks) == 0) return false;
    seat.generation = generationOf(blocks);
    dxPerturb(dxSchedulePoint::ClaimSeat);
    return takeOne(seats, seat.generation, seat.left);
}

// A block is reported as finished by whatever way it is left: a callback of the user's in it may end its thread.
void dxJobSlot::work(Seat seat, std::uint32_t left) {
    struct Report {
        dxFloatEnvironmentScope &scope;
        dxBarrier &barrier;
        ~Report() {
            scope.shareFlags();
            barrier.arrive(1);
        }
    };
    const unsigned worker = order.seats - seat.left + 1;
    dxFloatEnvironmentScope scope(environment);
    do {
        const Report report{scope, barrier};
        order.task(order.context, order.blocks - left, worker);
    } while (takeBlock(seat.generation, left));
}

bool dxJobSlot::takeBlock(std::uint32_t wanted, std::uint32_t &left) {
    dxPerturb(dxSchedulePoint::ClaimBlock);
    return takeOne(blocksLeft, wanted, left);
}
