// A world and a space with clusters, with given positions and expected clusters. Clusters are checked at
// every search, so that they are what the rules say.
#pragma once

#include <cstddef>
#include <vector>

#include <ode/ode.h>

#include "OdeSession.h"
#include "clusters/dxClusteredWorldAndSpace.h"
#include "clusters/dxClusterManager.h"

// The slot under which an ordered space knows a geom of its own.
dxMembers::Slot slotOf(dGeomID geom);

class ClusteredSpace {
public:
    explicit ClusteredSpace(const char *algorithm, dSpaceID (*create)(dSpaceID) = dHashSpaceCreate);
    ~ClusteredSpace();
    ClusteredSpace(const ClusteredSpace &) = delete;
    ClusteredSpace &operator=(const ClusteredSpace &) = delete;

    dWorldID world() const { return m_world; }
    dSpaceID space() const { return m_space; }

    // A cube with a body; a box without; both by their centre.
    dGeomID robot(dReal x, dReal y, dReal z, dReal edge = 1);
    dGeomID wall(dReal x, dReal y, dReal z, dReal lengthX, dReal lengthY = dReal(0.5), dReal lengthZ = 1);
    dGeomID floor(dReal z) { return dCreatePlane(m_space, 0, 0, 1, z); }
    static void moveTo(dGeomID geom, dReal x, dReal y, dReal z) { dGeomSetPosition(geom, x, y, z); }
    dJointID join(dGeomID a, dGeomID b);

    std::size_t collide();  // the number of callbacks

    const dxClusteredWorldAndSpace &clustered() const { return *dxClusterManager::find(m_space); }
    const dxClusters &clusters() const { return clustered().clusters(); }
    const dxClusters::Cluster &clusterOf(dGeomID geom) const { return clusters()[clusters().of(slotOf(geom))]; }
    bool isClustered(dGeomID geom) const { return clusters().of(slotOf(geom)) != dxClusters::kNone; }
    bool together(dGeomID a, dGeomID b) const;
    // The static geom is duplicated into the robot's cluster.
    bool duplicates(dGeomID robot, dGeomID fixed) const;
    // The robot's cluster is pseudo-merged with that of the static geom.
    bool pseudoMerges(dGeomID robot, dGeomID fixed) const;
    bool oneTask(dGeomID a, dGeomID b) const { return clusterOf(a).task == clusterOf(b).task; }

private:
    OdeSession m_session;
    dWorldID m_world;
    dSpaceID m_space;
};
