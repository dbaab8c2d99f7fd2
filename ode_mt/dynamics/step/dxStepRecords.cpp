#include "dynamics/step/dxStepRecords.h"

#include "threading/process/dxObjectPool.h"
#include "threading/process/dxProcess.h"

namespace {

dxProcessObject<dxObjectPool<dxStepRecords>> pool;

}  // namespace

void dxWorkerRecord::reset() {
    arena = nullptr;
    undo.clear();
    islands = 0;
}

dxStepRecords::Lease dxStepRecords::take() { return Lease(pool->takeOrMake()); }

void dxStepRecords::Return::operator()(dxStepRecords *records) const { pool->giveBack(records); }
