#include "settings/dxWorldWorkers.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <new>
#include <vector>

#include "config.h"
#include "objects.h"
#include "default_threading.h"
#include "threading/process/dxForkLocks.h"
#include "threading/pool/dxJobBoard.h"
#include "threading/process/dxProcessObject.h"
#include "threading/managers/dxThreadManagerUser.h"

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

class Managers {
public:
    // Keeps `entry` unless there is one for its implementation; returns the one that is kept.
    std::shared_ptr<dxThreadManagerUser> keep(Entry entry) {
        const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
        const auto found = find(entry.implementation);
        if (found != m_entries.end()) return found->manager;
        m_entries.push_back(entry);
        return entry.manager;
    }

    std::shared_ptr<dxThreadManagerUser> look(const Implementation &implementation) {
        const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
        const auto found = find(implementation);
        return found != m_entries.end() ? found->manager : nullptr;
    }

    std::shared_ptr<dxThreadManagerUser> remove(const Implementation &implementation) {
        const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
        const auto found = find(implementation);
        if (found == m_entries.end()) return nullptr;
        const std::shared_ptr<dxThreadManagerUser> manager = found->manager;
        m_entries.erase(found);
        return manager;
    }

private:
    std::vector<Entry>::iterator find(const Implementation &implementation) {
        return std::find_if(m_entries.begin(), m_entries.end(),
                            [&](const Entry &entry) { return entry.implementation == implementation; });
    }

    dxForkSafeMutex m_mutex;
    std::vector<Entry> m_entries;
};

dxProcessObject<Managers> managers;

std::shared_ptr<dxThreadManagerUser> managerOf(const dxWorld *world) {
    const Implementation implementation = Access::of(*world);
    if (auto manager = managers->look(implementation)) return manager;
    return managers->keep(
        {implementation, std::make_shared<dxThreadManagerUser>(implementation.functions, implementation.id)});
}

}  // namespace

bool given(const dxWorld *world) {
    return Access::of(*world).id != DefaultThreadingHolder::getDefaultThreadingImpl();
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
        manager = managerOf(world);
    } catch (const std::bad_alloc &) {
        return dxRunAlone(blocks, task, context);
    }
    manager->run(blocks, workers, task, context);
}

// The end of the manager, outside of all locks, waits for the threads that it has borrowed.
void giveBack(const dxWorld *world) { managers->remove(Access::of(*world)); }

}  // namespace dxWorldWorkers
