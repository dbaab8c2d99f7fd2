#include "collision/narrowphase/dxHeightField.h"

#include <mutex>
#include <new>
#include <unordered_set>

#include "collision/pairs/dxUnnoticedChanges.h"
#include "threading/process/dxFork.h"
#include "threading/process/dxProcess.h"

namespace {

struct Living {
    dxForkSafeMutex mutex;
    std::unordered_set<const dxHeightfieldData *> data;
};

dxProcessObject<Living> living;

}  // namespace

void dxLiveHeightfields::add(const dxHeightfieldData *data) {
    const std::lock_guard<dxForkSafeMutex> lock(living->mutex);
    try {
        living->data.insert(data);
    } catch (const std::bad_alloc &) {
    }
}

void dxLiveHeightfields::remove(const dxHeightfieldData *data) {
    const std::lock_guard<dxForkSafeMutex> lock(living->mutex);
    living->data.erase(data);
}

bool dxLiveHeightfields::has(const dxHeightfieldData *data) {
    const std::lock_guard<dxForkSafeMutex> lock(living->mutex);
    return living->data.count(data) != 0;
}

namespace dxTransformedGeom {

thread_local unsigned begun = 0;
std::atomic<bool> hasEverBegun{false};

void report() {
    begun = 0;
    dxMissedNotifications.add();
}

// Collisions that began later than this one were left by a jump into it, or have been reported.
void end(unsigned collision) {
    if (begun != collision) report();
    if (begun != 0) begun = collision - 1;
}

}  // namespace dxTransformedGeom
