#include "frame/dxClusterManager.h"

#include <cstring>

#include "collision/dxOrderedSpace.h"
#include "frame/dxTunedClusters.h"

namespace {

bool isOrdered(const dxSpace *space) {
    return space->type == dSimpleSpaceClass || space->type == dHashSpaceClass;
}

}  // namespace

const dxClusteredWorldAndSpace *dxClusterManager::find(dSpaceID space) {
    if (!isOrdered(space)) return nullptr;
    const dxPairSearch *const search = static_cast<const dxOrderedSpace *>(space)->search();
    return search != nullptr ? &static_cast<const dxTunedClusters *>(search)->clusters() : nullptr;
}

void dxClusterManager::prepare(dSpaceID space, const char *passName) {
    if (!isOrdered(space) || space->lock_count != 0) return;
    const dxClusteredWorldAndSpace *const present = find(space);
    dxOrderedSpace *const ordered = static_cast<dxOrderedSpace *>(space);
    if (passName == nullptr) {
        if (present != nullptr) ordered->setSearch(nullptr);
        return;
    }
    if (present != nullptr && std::strcmp(present->passName(), passName) == 0) return;
    ordered->setSearch(std::make_unique<dxTunedClusters>(dxMakeCrossoverPass(passName)));
}
