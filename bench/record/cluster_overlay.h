// The overlay of ODE_MT (ode_MT.h, group ode_mt_clusters) as plain data. Its functions are looked up by name:
// the program is linked to what Debian's library exports.
#pragma once

#include "record/recording.h"

#include <ode/ode.h>

namespace record {

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
