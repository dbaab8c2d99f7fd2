#include "clustering/dxClusterManager.h"

#include <cstring>

#include "clustering/dxClusteredWorldAndSpace.h"
#include "collision/dxOrderedSpace.h"

namespace {

bool isOrdered(const dxSpace *space) {
    return space->type == dSimpleSpaceClass || space->type == dHashSpaceClass;
}

}  // namespace

const dxClusteredWorldAndSpace *dxClusterManager::find(dSpaceID space) {
    if (!isOrdered(space)) return nullptr;
    return static_cast<const dxClusteredWorldAndSpace *>(static_cast<const dxOrderedSpace *>(space)->search());
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
    ordered->setSearch(std::make_unique<dxClusteredWorldAndSpace>(dxMakeCrossoverPass(passName)));
}
