// Contacts that are solved as rows: what dxContactReader is for contacts in lanes. They begin with the forces of the last step, and
// keep theirs for the next one.
//
// Threading: serial.
#pragma once

#include "dynamics/islands/dxIslandStep.h"
#include "dynamics/iterative/dxConstraintPlan.h"
#include "dynamics/iterative/dxContactForces.h"

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
