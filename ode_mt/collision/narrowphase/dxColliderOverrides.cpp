#include "collision/narrowphase/dxColliderOverrides.h"

#include <atomic>

#include <ode/collision.h>

namespace {

std::atomic<bool> overridden[dGeomNumClasses][dGeomNumClasses] = {};

}  // namespace

void dxColliderOverrides::note(int type1, int type2) { overridden[type1][type2] = overridden[type2][type1] = true; }

bool dxColliderOverrides::has(int type1, int type2) {
    return overridden[type1][type2].load(std::memory_order_relaxed);
}

void dxColliderOverrides::forget() {
    for (auto &row : overridden) {
        for (std::atomic<bool> &entry : row) entry.store(false, std::memory_order_relaxed);
    }
}
