#include "settings/dxLentThreads.h"

#include <algorithm>
#include <mutex>
#include <new>
#include <vector>

#include "config.h"
#include "objects.h"
#include "default_threading.h"
#include "threading/pool/dxJobBoard.h"
#include "threading/process/dxFork.h"
#include "threading/process/dxProcess.h"

namespace dxLentThreads {

namespace {

using Manager = std::shared_ptr<dxThreadManagerUser>;

struct Entry {
    dxThreadLender lender;
    Manager manager;
};

class Managers final : private dxForkListener {
public:
    Managers() { listenToForks(); }
    ~Managers() { ignoreForks(); }

    // Without memory for it a child goes on working alone.
    void lend(const dxThreadLender &lender) try {
        const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
        if (m_isChild && !isLentHere(lender)) m_lentHere.push_back(lender);
    } catch (const std::bad_alloc &) {
    }

    bool isServed(const dxThreadLender &lender) {
        const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
        return !m_isChild || isLentHere(lender);
    }

    // Keeps `entry` unless there is one for its lender; returns the one that is kept.
    Manager keep(const Entry &entry) {
        const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
        const auto found = find(entry.lender);
        if (found != m_entries.end()) return found->manager;
        m_entries.push_back(entry);
        return entry.manager;
    }

    Manager look(const dxThreadLender &lender) {
        const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
        const auto found = find(lender);
        return found != m_entries.end() ? found->manager : nullptr;
    }

    Manager remove(const dxThreadLender &lender) {
        const std::lock_guard<dxForkSafeMutex> hold(m_mutex);
        const auto found = find(lender);
        if (found == m_entries.end()) return nullptr;
        Manager manager = std::move(found->manager);
        m_entries.erase(found);
        return manager;
    }

private:
    void inForkedChild() override {
        m_isChild = true;
        m_lentHere.clear();
    }

    bool isLentHere(const dxThreadLender &lender) const { return std::find(m_lentHere.begin(), m_lentHere.end(), lender) != m_lentHere.end(); }

    std::vector<Entry>::iterator find(const dxThreadLender &lender) {
        return std::find_if(m_entries.begin(), m_entries.end(), [&](const Entry &entry) { return entry.lender == lender; });
    }

    dxForkSafeMutex m_mutex;
    std::vector<Entry> m_entries;
    bool m_isChild = false;                  // of a fork
    std::vector<dxThreadLender> m_lentHere;  // by a child, each once
};

dxProcessObject<Managers> managers;

}  // namespace

void lend(const dxThreadLender &lender) { managers->lend(lender); }

Manager managerOf(const dxThreadLender &lender) {
    if (Manager manager = managers->look(lender)) return manager;
    return managers->keep({lender, std::make_shared<dxThreadManagerUser>(lender, managers->isServed(lender))});
}

// The manager ends outside of all locks, and waits for the lent threads that are inside.
void giveBack(const dxThreadLender &lender) { managers->remove(lender); }

}  // namespace dxLentThreads

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
