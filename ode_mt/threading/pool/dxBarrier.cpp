#include "threading/pool/dxBarrier.h"

#include "threading/dxSchedulePoints.h"
#include "threading/pool/dxSpin.h"

void dxBarrier::reset(unsigned blocks) { pending.store(blocks, std::memory_order_relaxed); }

// `pending` and `sleeping` are sequentially consistent: either the last one to arrive sees the sleeper,
// or the sleeper sees zero.
void dxBarrier::arrive(unsigned blocks) {
    dxPerturb(dxSchedulePoint::FinishBlocks);
    if (pending.fetch_sub(blocks) == blocks && sleeping.load()) dxFutexWake(pending, 1);
}

void dxBarrier::wait() {
    if (dxSpinUntil([this] { return pending.load(std::memory_order_acquire) == 0; }, dxLastBlocksTime))
        return;
    dxPerturb(dxSchedulePoint::AwaitBlocks);
    sleeping.store(true);
    while (const std::uint32_t left = pending.load()) dxFutexWait(pending, left);
    sleeping.store(false);
}
