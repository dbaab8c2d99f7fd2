// Functions of ode/ode_MT.h that tell a debug overlay of clusters.
#include <ode/error.h>
#include <ode/ode_MT.h>

#include <algorithm>

#include "clusters/dxClusteredWorldAndSpace.h"
#include "clusters/dxClusterManager.h"
#include "collision/spaces/dxOrderedSpace.h"

namespace {

constexpr unsigned kNoCluster = 0;

void require(bool condition, const char *function, const char *what) {
    if (!condition) dDebug(d_ERR_UASSERT, "%s in %s()", what, function);
}

// NULL: the space has no clusters.
const dxClusteredWorldAndSpace *clustersOf(const char *function, dWorldID world, dSpaceID space) {
    require(world != nullptr, function, "bad world argument");
    require(space != nullptr && dGeomIsSpace(space), function, "bad space argument");
    return dxClusterManager::find(space);
}

unsigned nameOf(const dxClusteredWorldAndSpace &clustered, dxMembers::Slot slot) {
    const int cluster = clustered.clusters().of(slot);
    const bool isDynamic = cluster != dxClusters::kNone && cluster < clustered.clusters().dynamicCount();
    return isDynamic ? clustered.clusters()[cluster].name : kNoCluster;
}

// The space with clusters that a geom is in, itself or with a space around it, and its slot there.
struct Place {
    const dxClusteredWorldAndSpace *clustered = nullptr;  // NULL: there is none, or the geom has come since it looked
    dxMembers::Slot slot = 0;
};

Place placeOf(dGeomID geom) {
    for (; geom != nullptr; geom = geom->parent_space) {
        const dxOrderedSpace *const space = dxOrderedSpace::of(geom);
        if (space == nullptr) continue;
        const dxClusteredWorldAndSpace *const clustered = dxClusterManager::find(geom->parent_space);
        const dxMembers::Slot slot = dxOrderedSpace::slotOf(geom);
        if (clustered != nullptr && clustered->knows(slot, space->members())) return {clustered, slot};
    }
    return {};
}

}  // namespace

extern "C" {

int dClusterGetCount(dWorldID world, dSpaceID space) {
    const dxClusteredWorldAndSpace *const clustered = clustersOf(__func__, world, space);
    return clustered != nullptr ? clustered->clusters().dynamicCount() : 1;
}

float dClusterGetGridStep(dWorldID world, dSpaceID space) {
    const dxClusteredWorldAndSpace *const clustered = clustersOf(__func__, world, space);
    return clustered != nullptr ? static_cast<float>(clustered->scene().grid().edge()) : 0;
}

void dClusterGetCenter(dWorldID world, dSpaceID space, float *x, float *y, float *z) {
    const dxClusteredWorldAndSpace *const clustered = clustersOf(__func__, world, space);
    require(x != nullptr, __func__, "bad x argument");
    require(y != nullptr, __func__, "bad y argument");
    require(z != nullptr, __func__, "bad z argument");
    constexpr dReal kOrigin[3] = {0, 0, 0};
    const dReal *const centre = clustered != nullptr ? clustered->scene().grid().centre() : kOrigin;
    *x = static_cast<float>(centre[0]);
    *y = static_cast<float>(centre[1]);
    *z = static_cast<float>(centre[2]);
}

int dClusterGetGridCells(dWorldID world, dSpaceID space) {
    const dxClusteredWorldAndSpace *const clustered = clustersOf(__func__, world, space);
    return clustered != nullptr ? clustered->scene().grid().cells() : 0;
}

unsigned dClusterGetOfGeom(dGeomID geom) {
    require(geom != nullptr, __func__, "bad geom argument");
    const Place place = placeOf(geom);
    return place.clustered != nullptr ? nameOf(*place.clustered, place.slot) : kNoCluster;
}

unsigned dClusterGetStaticOfGeom(dGeomID geom) {
    require(geom != nullptr, __func__, "bad geom argument");
    const Place place = placeOf(geom);
    if (place.clustered == nullptr) return kNoCluster;
    const dxClusters &clusters = place.clustered->clusters();
    const int cluster = clusters.of(place.slot);
    return cluster >= clusters.dynamicCount() ? static_cast<unsigned>(cluster - clusters.dynamicCount() + 1)
                                              : kNoCluster;
}

int dClusterGetTestedWith(dGeomID geom, unsigned *names, int capacity) {
    require(geom != nullptr, __func__, "bad geom argument");
    require(names != nullptr || capacity <= 0, __func__, "bad clusters argument");
    const Place place = placeOf(geom);
    if (place.clustered == nullptr) return 0;
    const dxClusters &clusters = place.clustered->clusters();
    int count = 0;
    for (int cluster = 0; cluster < clusters.dynamicCount(); ++cluster) {
        if (!place.clustered->isTestedWith(place.slot, cluster)) continue;
        if (count < capacity) names[count] = clusters[cluster].name;
        ++count;
    }
    return count;
}

unsigned dClusterGetOfBody(dBodyID body) {
    require(body != nullptr, __func__, "bad body argument");
    const dGeomID geom = dBodyGetFirstGeom(body);
    return geom != nullptr ? dClusterGetOfGeom(geom) : kNoCluster;
}

int dClusterGetCells(dWorldID world, dSpaceID space, dClusterCell *cells, int capacity) {
    const dxClusteredWorldAndSpace *const clustered = clustersOf(__func__, world, space);
    require(cells != nullptr || capacity <= 0, __func__, "bad cells argument");
    if (clustered == nullptr) return 0;
    const dxClusterScene &scene = clustered->scene();
    const std::vector<int> &occupied = scene.occupied();
    const int side = scene.grid().cells(), count = static_cast<int>(occupied.size());
    for (int i = 0; i < std::min(count, capacity); ++i) {
        const int cell = occupied[i];
        const dxMembers::Slot first = scene.in(cell, dxClusterScene::Kind::dynamicGeom).front();
        cells[i] = {cell / (side * side), cell / side % side, cell % side, nameOf(*clustered, first)};
    }
    return count;
}

int dClusterGetEvents(dWorldID world, dSpaceID space, dClusterEvent *events, int capacity) {
    const dxClusteredWorldAndSpace *const clustered = clustersOf(__func__, world, space);
    require(events != nullptr || capacity <= 0, __func__, "bad events argument");
    if (clustered == nullptr) return 0;
    const std::vector<dxClusterChange> &changes = clustered->history().changes();
    const int count = static_cast<int>(changes.size());
    for (int i = 0; i < std::min(count, capacity); ++i)
        events[i] = {changes[i].kind == dxClusterChange::Kind::split, changes[i].from, changes[i].into};
    return count;
}

}  // extern "C"
