#include "settings/dxWorldWorkers.h"

#include <memory>
#include <new>

#include "config.h"
#include "objects.h"
#include "default_threading.h"
#include "settings/dxLentThreads.h"
#include "threading/pool/dxJobBoard.h"

namespace dxWorldWorkers {

namespace {

// Upstream shows a world's implementation to classes derived from dxThreadingBase only.
struct Access : dxThreadingBase {
    static dxThreadLender of(const dxThreadingBase &base) {
        dxThreadLender lender;
        lender.functions = (base.*(&Access::FindThreadingImpl))(lender.implementation);
        return lender;
    }
};

}  // namespace

bool given(const dxWorld *world) {
    return Access::of(*world).implementation != DefaultThreadingHolder::getDefaultThreadingImpl();
}

bool haveToBeAsked(const dxWorld *world) {
    const bool areTheUsers = Access::of(*world).functions != DefaultThreadingHolder::getDefaultThreadingFunctions();
    return given(world) && areTheUsers && (world->islands_max_threads == 1 || count(world) < 2);
}

unsigned count(const dxWorld *world) { return world->RetrieveThreadingThreadCount(); }

bool prepare(const dxWorld *world) {
    constexpr unsigned kCallsAtOnce = 1;  // dxThreadManagerUser has at most one call waiting
    return !given(world) || world->PreallocateResourcesForThreadedCalls(kCallsAtOnce);
}

void run(const dxWorld *world, unsigned blocks, unsigned workers, dxThreadManager::Task task, void *context) {
    std::shared_ptr<dxThreadManagerUser> manager;
    try {
        manager = dxLentThreads::managerOf(Access::of(*world));
    } catch (const std::bad_alloc &) {
        return dxRunAlone(blocks, task, context);
    }
    manager->run(blocks, workers, task, context);
}

void lend(const dxWorld *world) {
    if (given(world)) dxLentThreads::lend(Access::of(*world));
}

void giveBack(const dxWorld *world) { dxLentThreads::giveBack(Access::of(*world)); }

}  // namespace dxWorldWorkers
