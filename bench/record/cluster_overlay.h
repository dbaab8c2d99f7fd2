// What our library says of bodies, beside their states: in which cluster each is, and which worker stepped it.
#pragma once

#include <ode/ode.h>

#include <vector>

#include "record/recording.h"

namespace record {

// Which thread of ODE_MT's steps each body.
class BodyWorkers {
public:
    // From now on steps note it. Throws std::runtime_error if the library cannot.
    BodyWorkers();

    // In the last step: 0: the thread that called it; n: worker n; -1: none, the body slept.
    std::vector<int> of(const std::vector<dBodyID> &bodies) const;

private:
    decltype(&dODE_MT_GetBodyWorker) m_get;
};

// The overlay of ODE_MT (ode_MT.h, group ode_mt_clusters) as plain data. Its functions are looked up by name:
// the program is linked to what Debian's library exports.
class ClusterOverlay {
public:
    // Throws std::runtime_error if the library has none of these functions.
    ClusterOverlay();

    int clusters(dWorldID world, dSpaceID space) const { return m_count(world, space); }
    Grid grid(dWorldID world, dSpaceID space) const;
    std::vector<Cell> cells(dWorldID world, dSpaceID space) const;
    std::vector<Event> events(dWorldID world, dSpaceID space) const;
    unsigned of(dBodyID body) const { return m_ofBody(body); }
    Membership of(dGeomID geom) const;

private:
    // The C function, not the form with references.
    using GetCenter = void (*)(dWorldID, dSpaceID, float *, float *, float *);

    decltype(&dClusterGetCount) m_count;
    decltype(&dClusterGetGridCells) m_gridCells;
    decltype(&dClusterGetGridStep) m_gridStep;
    GetCenter m_center;
    decltype(&dClusterGetCells) m_cells;
    decltype(&dClusterGetEvents) m_events;
    decltype(&dClusterGetOfBody) m_ofBody;
    decltype(&dClusterGetOfGeom) m_ofGeom;
    decltype(&dClusterGetStaticOfGeom) m_staticOfGeom;
    decltype(&dClusterGetTestedWith) m_testedWith;
};

}  // namespace record
