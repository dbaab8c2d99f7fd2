#include "dxUserThreadManagers.h"

#include <algorithm>
#include <iterator>
#include <mutex>
#include <new>
#include <vector>

#include "dxForkListener.h"

namespace {

struct Entry {
    const dThreadingFunctionsInfo *functions;
    dThreadingImplementationID implementation;
    std::shared_ptr<dxThreadManagerUser> manager;
};

// Implementations that the user has freed leave entries behind. Beyond this number the idle ones go.
constexpr std::size_t entriesKept = 8;

class Table final : private dxForkListener {
public:
    Table() { listenToForks(); }
    ~Table() { ignoreForks(); }

    std::shared_ptr<dxThreadManagerUser> find(const Entry &wanted) {
        if (auto found = look(wanted)) return found;
        const std::lock_guard<std::mutex> hold(making);
        if (auto found = look(wanted)) return found;
        drop(entriesKept);
        Entry entry = wanted;
        entry.manager = std::make_shared<dxThreadManagerUser>(entry.functions, entry.implementation);
        const std::lock_guard<std::mutex> change(lock);
        entries.push_back(entry);
        return entry.manager;
    }

    void clear() {
        const std::lock_guard<std::mutex> hold(making);
        drop(0);
    }

private:
    std::shared_ptr<dxThreadManagerUser> look(const Entry &wanted) {
        const std::lock_guard<std::mutex> read(lock);
        for (const Entry &e : entries) {
            if (e.functions == wanted.functions && e.implementation == wanted.implementation) return e.manager;
        }
        return nullptr;
    }

    // Drops what nobody uses, if there are at least `kept` entries and, with kept > 0, only what is idle.
    void drop(std::size_t kept) {
        std::vector<Entry> dropped;
        const std::lock_guard<std::mutex> change(lock);
        if (entries.size() < kept) return;
        const auto first = std::stable_partition(entries.begin(), entries.end(), [&](const Entry &e) {
            return e.manager.use_count() > 1 || (kept > 0 && !e.manager->idle());
        });
        dropped.assign(std::make_move_iterator(first), std::make_move_iterator(entries.end()));
        entries.erase(first, entries.end());
    }

    void beforeFork() override { lock.lock(); }
    void inForkingParent() override { lock.unlock(); }
    void inForkedChild() override {
        lock.unlock();
        new (&making) std::mutex;
    }

    // `making` is held while managers are made and destroyed, which registers them with the fork handlers;
    // `lock` is held by the fork handlers, so that the child finds the entries whole. Hence two.
    std::mutex making;
    std::mutex lock;
    std::vector<Entry> entries;
};

Table &table() {
    static Table theTable;
    return theTable;
}

}  // namespace

namespace dxUserThreadManagers {

std::shared_ptr<dxThreadManager> find(const dThreadingFunctionsInfo *functions,
                                      dThreadingImplementationID implementation) {
    return table().find({functions, implementation, nullptr});
}

void clear() { table().clear(); }

}  // namespace dxUserThreadManagers
