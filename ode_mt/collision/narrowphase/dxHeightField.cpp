#include "collision/narrowphase/dxHeightField.h"

#include <mutex>
#include <new>
#include <unordered_set>

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
