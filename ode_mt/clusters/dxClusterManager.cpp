#include "clusters/dxClusterManager.h"

#include <cstring>
#include <new>

#include "clusters/dxTunedClusters.h"
#include "collision/spaces/dxOrderedSpace.h"

namespace {

// A space's search, if it has one, was set by prepare().
dxTunedClusters *tunedOf(dxSpace *space) {
    dxOrderedSpace *const ordered = dxOrderedSpace::from(space);
    return ordered != nullptr ? static_cast<dxTunedClusters *>(ordered->broadphase()) : nullptr;
}

}  // namespace

const dxClusteredWorldAndSpace *dxClusterManager::find(dSpaceID space) {
    const dxTunedClusters *const tuned = tunedOf(space);
    return tuned != nullptr ? &tuned->clusters() : nullptr;
}

void dxClusterManager::prepare(dSpaceID space, const char *passName) {
    dxOrderedSpace *const ordered = dxOrderedSpace::from(space);
    if (ordered == nullptr || ordered->lock_count != 0) return;
    dxTunedClusters *const present = tunedOf(space);
    if (passName == nullptr) {
        if (present != nullptr) ordered->setBroadphase(nullptr);
        return;
    }
    if (present != nullptr && std::strcmp(present->clusters().passName(), passName) == 0) {
        present->beginFrame();
        return;
    }
    try {
        ordered->setBroadphase(std::make_unique<dxTunedClusters>(dxMakeCrossoverPass(passName)));
    } catch (const std::bad_alloc &) {  // without clusters this time
        ordered->setBroadphase(nullptr);
    }
}
