#include "collision/narrowphase/dxLivingHeights.h"

#include <mutex>
#include <new>
#include <unordered_set>

#include "threading/process/dxForkLocks.h"
#include "threading/process/dxProcessObject.h"

namespace {

struct Living {
    dxForkSafeMutex mutex;
    std::unordered_set<const dxHeightfieldData *> data;
};

dxProcessObject<Living> living;

}  // namespace

void dxLivingHeights::add(const dxHeightfieldData *data) {
    const std::lock_guard<dxForkSafeMutex> lock(living->mutex);
    try {
        living->data.insert(data);
    } catch (const std::bad_alloc &) {
    }
}

void dxLivingHeights::remove(const dxHeightfieldData *data) {
    const std::lock_guard<dxForkSafeMutex> lock(living->mutex);
    living->data.erase(data);
}

bool dxLivingHeights::has(const dxHeightfieldData *data) {
    const std::lock_guard<dxForkSafeMutex> lock(living->mutex);
    return living->data.count(data) != 0;
}
