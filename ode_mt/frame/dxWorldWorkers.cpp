#include "frame/dxWorldWorkers.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <vector>

#include "default_threading.h"
#include "threading/dxThreadManagerUser.h"

namespace dxWorldWorkers {

namespace {

struct Implementation {
    const dxThreadingFunctionsInfo *functions;
    dThreadingImplementationID id;

    bool operator==(const Implementation &other) const {
        return functions == other.functions && id == other.id;
    }
};

// Upstream shows a world's implementation to classes derived from dxThreadingBase only.
struct Access : dxThreadingBase {
    static Implementation of(const dxThreadingBase &base) {
        Implementation result;
        result.functions = (base.*(&Access::FindThreadingImpl))(result.id);
        return result;
    }
};

struct Entry {
    Implementation implementation;
    std::shared_ptr<dxThreadManagerUser> manager;
};

struct Managers {
    std::mutex mutex;
    std::vector<Entry> entries;

    std::vector<Entry>::iterator find(const Implementation &implementation) {
        return std::find_if(entries.begin(), entries.end(),
                            [&](const Entry &entry) { return entry.implementation == implementation; });
    }
};

// Never destroyed: steps may still run while the process ends.
Managers &managers() {
    static Managers *const instance = new Managers;
    return *instance;
}

std::shared_ptr<dxThreadManagerUser> managerOf(const dxWorld *world) {
    const Implementation implementation = Access::of(*world);
    std::lock_guard<std::mutex> lock(managers().mutex);
    auto found = managers().find(implementation);
    if (found != managers().entries.end()) return found->manager;
    auto manager = std::make_shared<dxThreadManagerUser>(implementation.functions, implementation.id);
    managers().entries.push_back({implementation, manager});
    return manager;
}

}  // namespace

bool given(const dxWorld *world) {
    return Access::of(*world).functions != DefaultThreadingHolder::getDefaultThreadingFunctions();
}

unsigned count(const dxWorld *world) { return world->RetrieveThreadingThreadCount(); }

bool prepare(const dxWorld *world) {
    constexpr unsigned kCallsAtOnce = 1;  // dxThreadManagerUser has at most one call waiting
    return !given(world) || world->PreallocateResourcesForThreadedCalls(kCallsAtOnce);
}

void run(const dxWorld *world, unsigned blocks, unsigned workers, dxThreadManager::Task task, void *context) {
    managerOf(world)->run(blocks, workers, task, context);
}

void giveBack(const dxWorld *world) {
    const Implementation implementation = Access::of(*world);
    std::shared_ptr<dxThreadManagerUser> manager;
    std::unique_lock<std::mutex> lock(managers().mutex);
    auto found = managers().find(implementation);
    if (found == managers().entries.end()) return;
    manager = std::move(found->manager);
    managers().entries.erase(found);
    lock.unlock();  // its end waits for the threads it has borrowed
}

}  // namespace dxWorldWorkers
