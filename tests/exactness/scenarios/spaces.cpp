#include "spaces.h"

namespace exactness {

const char *nameOf(scenes::SpaceKind kind) {
    switch (kind) {
        case scenes::SpaceKind::Simple:
            return "simple";
        case scenes::SpaceKind::Hash:
            return "hash";
        case scenes::SpaceKind::SweepAndPrune:
            return "sweep_and_prune";
        case scenes::SpaceKind::QuadTree:
            break;
    }
    return "quad_tree";
}

dSpaceID createSpace(scenes::SpaceKind kind, dSpaceID parent) {
    const dVector3 center = {0, 0, 0}, extents = {100, 100, 100};  // m; geoms outside stay in the root block
    switch (kind) {
        case scenes::SpaceKind::Simple:
            return dSimpleSpaceCreate(parent);
        case scenes::SpaceKind::Hash:
            return dHashSpaceCreate(parent);
        case scenes::SpaceKind::SweepAndPrune:
            return dSweepAndPruneSpaceCreate(parent, dSAP_AXES_ZYX);
        case scenes::SpaceKind::QuadTree:
            break;
    }
    return dQuadTreeSpaceCreate(parent, center, extents, 4);
}

}  // namespace exactness
