#include "clusters/dxClusterManager.h"

#include <cstring>
#include <new>

#include "clusters/dxClusterBroadphase.h"
#include "collision/spaces/dxOrderedSpace.h"

namespace {

// No function but prepare() sets the broad phase of a space.
dxClusterBroadphase *broadphaseOf(dxSpace *space) {
    dxOrderedSpace *const ordered = dxOrderedSpace::from(space);
    return ordered != nullptr ? static_cast<dxClusterBroadphase *>(ordered->broadphase()) : nullptr;
}

}  // namespace

const dxClusteredWorldAndSpace *dxClusterManager::find(dSpaceID space) {
    const dxClusterBroadphase *const broadphase = broadphaseOf(space);
    return broadphase != nullptr ? &broadphase->clusters() : nullptr;
}

void dxClusterManager::prepare(dSpaceID space, const char *passName) {
    dxOrderedSpace *const ordered = dxOrderedSpace::from(space);
    if (ordered == nullptr || ordered->lock_count != 0) return;
    dxClusterBroadphase *const present = broadphaseOf(space);
    if (passName == nullptr) {
        if (present != nullptr) ordered->setBroadphase(nullptr);
        return;
    }
    if (present != nullptr && std::strcmp(present->clusters().passName(), passName) == 0) {
        present->beginFrame();
        return;
    }
    try {
        ordered->setBroadphase(std::make_unique<dxClusterBroadphase>(dxMakeCrossoverPass(passName)));
    } catch (const std::bad_alloc &) {  // without clusters this time
        ordered->setBroadphase(nullptr);
    }
}
