#include "threading/pool/dxJobBoard.h"

#include "threading/dxSchedulePoints.h"
#include "threading/pool/dxSpin.h"

namespace {

std::uint64_t join(std::uint32_t generation, std::uint32_t left) { return std::uint64_t{generation} << 32 | left; }
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

std::uint64_t bit(unsigned slot) { return std::uint64_t{1} << slot; }

// Returns the lowest set bit. Requires a mask other than zero.
unsigned lowest(std::uint64_t mask) { return static_cast<unsigned>(__builtin_ctzll(mask)); }

}  // namespace

// --- the barrier -------------------------------------------------------------------------------------------

void dxBarrier::reset(unsigned blocks) { m_pending.store(blocks, std::memory_order_relaxed); }

// m_pending and m_isSleeping are sequentially consistent: either the last one to arrive sees the sleeper, or the sleeper sees zero.
void dxBarrier::arrive(unsigned blocks) {
    dxPerturb(dxSchedulePoint::FinishBlocks);
    if (m_pending.fetch_sub(blocks) == blocks && m_isSleeping.load()) dxFutexWake(m_pending, 1);
}

void dxBarrier::wait() {
    if (dxSpinUntil([this] { return m_pending.load(std::memory_order_acquire) == 0; }, kLastBlocksTime)) return;
    dxPerturb(dxSchedulePoint::AwaitBlocks);
    m_isSleeping.store(true);
    while (const std::uint32_t left = m_pending.load()) dxFutexWait(m_pending, left);
    m_isSleeping.store(false);
}

// --- one run -----------------------------------------------------------------------------------------------

void dxJobSlot::open(const Order &order) {
    m_order = order;
    m_takenByCaller = 0;
    m_environment.capture();
    m_barrier.reset(order.blocks);
    ++m_generation;
    m_seats.store(join(m_generation, order.seats), std::memory_order_release);
    dxPerturb(dxSchedulePoint::OpenRun);
    m_blocksLeft.store(join(m_generation, order.blocks), std::memory_order_release);
}

void dxJobSlot::runAsCaller() {
    std::uint32_t left;
    while (takeBlock(m_generation, left)) {
        ++m_takenByCaller;
        m_order.task(m_order.context, m_order.blocks - left, 0);
    }
}

void dxJobSlot::finish() {
    m_barrier.arrive(m_takenByCaller);
    m_barrier.wait();
    m_environment.raiseFlags();
}

bool dxJobSlot::canJoin() const {
    const std::uint64_t blocks = m_blocksLeft.load(std::memory_order_acquire);
    if (leftOf(blocks) == 0) return false;
    const std::uint64_t free = m_seats.load(std::memory_order_relaxed);
    return generationOf(free) == generationOf(blocks) && leftOf(free) > 0;
}

void dxJobSlot::abandon() {
    m_blocksLeft.store(join(m_generation, 0));
    m_seats.store(join(m_generation, 0));
    m_barrier.reset(0);
}

bool dxJobSlot::takeSeat(Seat &seat) {
    const std::uint64_t blocks = m_blocksLeft.load(std::memory_order_acquire);
    if (leftOf(blocks) == 0) return false;
    seat.generation = generationOf(blocks);
    dxPerturb(dxSchedulePoint::ClaimSeat);
    return takeOne(m_seats, seat.generation, seat.left);
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
    const unsigned worker = m_order.seats - seat.left + 1;
    dxFloatEnvironmentScope scope(m_environment);
    do {
        const Report report{scope, m_barrier};
        m_order.task(m_order.context, m_order.blocks - left, worker);
    } while (takeBlock(seat.generation, left));
}

bool dxJobSlot::takeBlock(std::uint32_t generation, std::uint32_t &left) {
    dxPerturb(dxSchedulePoint::ClaimBlock);
    return takeOne(m_blocksLeft, generation, left);
}

// --- the board ---------------------------------------------------------------------------------------------

void dxRunAlone(unsigned blocks, dxThreadManager::Task task, void *context) {
    for (unsigned block = 0; block < blocks; ++block) {
        dxPerturb(dxSchedulePoint::RunAlone);
        task(context, block, 0);
    }
}

void dxJobBoard::run(const dxJobSlot::Order &order, dxWorkerSource &source) {
    const unsigned index = acquire();
    if (index == kSlots) {
        dxRunAlone(order.blocks, order.task, order.context);
        return;
    }
    const Completion completion{*this, index};
    m_slots[index].open(order);
    m_open.fetch_or(bit(index));
    source.requestWorkers(order.seats);
    m_slots[index].runAsCaller();
}

// The thread may be at its end, in a block of its own or where the system lets it be cancelled. The blocks that are left are run all the same, since
// the run's order is about to go with the thread's stack.
dxJobBoard::Completion::~Completion() {
    dxJobSlot &slot = board.m_slots[index];
    slot.runAsCaller();
    dxPerturb(dxSchedulePoint::CloseRun);
    board.m_open.fetch_and(~bit(index));
    slot.finish();
    board.release(index);
}

void dxJobBoard::abandon() {
    for (dxJobSlot &slot : m_slots) slot.abandon();
    m_open.store(0);
    m_used.store(0);
}

dxJobSlot *dxJobBoard::find() {
    for (std::uint64_t left = m_open.load(); left != 0; left &= left - 1) {
        dxJobSlot &slot = m_slots[lowest(left)];
        if (slot.canJoin()) return &slot;
    }
    return nullptr;
}

unsigned dxJobBoard::acquire() {
    std::uint64_t now = m_used.load(std::memory_order_relaxed);
    dxPerturb(dxSchedulePoint::ClaimSlot);
    do {
        if (~now == 0) return kSlots;
    } while (!m_used.compare_exchange_weak(now, now | (now + 1), std::memory_order_acquire, std::memory_order_relaxed));
    return lowest(~now);
}

void dxJobBoard::release(unsigned slot) { m_used.fetch_and(~bit(slot), std::memory_order_release); }
