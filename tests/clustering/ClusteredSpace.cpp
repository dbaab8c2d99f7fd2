#include "ClusteredSpace.h"

#include <algorithm>
#include <cstdint>

#include "collision/spaces/dxOrderedSpace.h"

namespace {

template <class T>
bool contains(const std::vector<T> &values, T value) {
    return std::find(values.begin(), values.end(), value) != values.end();
}

void countPair(void *count, dGeomID, dGeomID) { ++*static_cast<std::size_t *>(count); }

}  // namespace

dxMembers::Slot slotOf(dGeomID geom) {
    return static_cast<dxMembers::Slot>(reinterpret_cast<std::uintptr_t>(geom->tome_ex) - 1);
}

ClusteredSpace::ClusteredSpace(const char *algorithm, dSpaceID (*create)(dSpaceID))
    : m_session(0, algorithm), m_world(dWorldCreate()), m_space(create(nullptr)) {
    dODE_MT_SetHeuristics("cells,centre");
}

ClusteredSpace::~ClusteredSpace() {
    dSpaceDestroy(m_space);
    dWorldDestroy(m_world);
    dODE_MT_SetHeuristics("default");
}

dGeomID ClusteredSpace::robot(dReal x, dReal y, dReal z, dReal edge) {
    const dGeomID geom = dCreateBox(m_space, edge, edge, edge);
    dGeomSetBody(geom, dBodyCreate(m_world));
    moveTo(geom, x, y, z);
    return geom;
}

dGeomID ClusteredSpace::wall(dReal x, dReal y, dReal z, dReal lengthX, dReal lengthY, dReal lengthZ) {
    const dGeomID geom = dCreateBox(m_space, lengthX, lengthY, lengthZ);
    moveTo(geom, x, y, z);
    return geom;
}

dJointID ClusteredSpace::join(dGeomID a, dGeomID b) {
    const dJointID joint = dJointCreateBall(m_world, nullptr);
    dJointAttach(joint, dGeomGetBody(a), dGeomGetBody(b));
    return joint;
}

std::size_t ClusteredSpace::collide() {
    std::size_t count = 0;
    dSpaceCollide(m_space, &count, countPair);
    return count;
}

bool ClusteredSpace::together(dGeomID a, dGeomID b) const {
    return isClustered(a) && clusters().of(slotOf(a)) == clusters().of(slotOf(b));
}

bool ClusteredSpace::duplicates(dGeomID robot, dGeomID fixed) const {
    return contains(clusterOf(robot).duplicated, slotOf(fixed));
}

bool ClusteredSpace::pseudoMerges(dGeomID robot, dGeomID fixed) const {
    return isClustered(fixed) && contains(clusterOf(robot).staticClusters, clusters().of(slotOf(fixed)));
}
