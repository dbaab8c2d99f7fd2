// Contacts that are solved as rows: what dxContactReader is for contacts in lanes. They begin with the forces of the last step, and
// keep theirs for the next one.
//
// Threading: serial.
#pragma once

#include "dynamics/quick_step/fast/dxConstraintPlan.h"
#include "dynamics/quick_step/fast/dxContactForces.h"
#include "dynamics/step/islands/dxIslandStep.h"

class dxOtherRows;

class dxRowContacts {
public:
    dxRowContacts(const dxIslandStep &step, dxConstraintPlan &plan);

    // Writes impulses to the rows, which joints have just written.
    void start(dxOtherRows &rows) const;

    // After dxContactReader::list(). Requires impulses in the rows.
    void keep(const dxOtherRows &rows) const;

private:
    dReal armOf(unsigned joint, bool isOfFirst, int axis) const;
    dReal normalOf(unsigned joint, int axis) const;

    const dxIslandStep &m_step;
    std::vector<dxConstraintPlan::Manifold> &m_manifolds;
    dxContactForces &m_forces;
};
