#include "settings/dxLentThreads.h"

#include <algorithm>
#include <mutex>
#include <vector>

#include "threading/process/dxForkLocks.h"
#include "threading/process/dxProcessObject.h"

namespace dxLentThreads {

namespace {

using Manager = std::shared_ptr<dxThreadManagerUser>;

struct Entry {
    dxThreadLender lender;
    Manager manager;
};

class Managers {
public:
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
    std::vector<Entry>::iterator find(const dxThreadLender &lender) {
        return std::find_if(m_entries.begin(), m_entries.end(), [&](const Entry &entry) { return entry.lender == lender; });
    }

    dxForkSafeMutex m_mutex;
    std::vector<Entry> m_entries;
};

dxProcessObject<Managers> managers;

}  // namespace

Manager managerOf(const dxThreadLender &lender) {
    if (Manager manager = managers->look(lender)) return manager;
    return managers->keep({lender, std::make_shared<dxThreadManagerUser>(lender)});
}

// The end of the manager, outside of all locks, waits for the threads that it has borrowed.
void giveBack(const dxThreadLender &lender) { managers->remove(lender); }

}  // namespace dxLentThreads
