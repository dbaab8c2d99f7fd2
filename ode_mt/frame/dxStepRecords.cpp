#include "frame/dxStepRecords.h"

#include <mutex>

namespace {

struct Pool {
    std::mutex mutex;
    std::vector<std::unique_ptr<dxStepRecords>> idle;
};

// Never destroyed: steps may still run while the process ends.
Pool &pool() {
    static Pool *const instance = new Pool;
    return *instance;
}

}  // namespace

void dxWorkerRecord::reset() {
    arena = nullptr;
    undo.clear();
    reports.clear();
    feedbacks.clear();
    busyNs = 0;
    islands = 0;
}

dxStepRecords::Lease dxStepRecords::borrow() {
    std::lock_guard<std::mutex> lock(pool().mutex);
    if (pool().idle.empty()) return Lease(new dxStepRecords);
    Lease lease(pool().idle.back().release());
    pool().idle.pop_back();
    return lease;
}

void dxStepRecords::Return::operator()(dxStepRecords *records) const {
    std::lock_guard<std::mutex> lock(pool().mutex);
    pool().idle.emplace_back(records);
}

void dxStepRecords::release() {
    std::lock_guard<std::mutex> lock(pool().mutex);
    pool().idle.clear();
    pool().idle.shrink_to_fit();
}
