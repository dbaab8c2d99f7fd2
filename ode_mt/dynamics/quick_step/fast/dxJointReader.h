// Joints other than contacts to lanes (dxJointPack.h), and forces back: asks the joints for their rows, as dxJointRows does, and writes these into
// packs.
//
// Threading: several threads may read the bodies, and keep the forces, of different packs at the same time; read() shares joints out among the
// island's workers where none of them pushes its bodies; all else is serial.
#pragma once

#include "dynamics/quick_step/fast/dxConstraintPlan.h"
#include "dynamics/quick_step/fast/dxJointPack.h"
#include "dynamics/step/islands/dxIslandStep.h"

class dxJointReader {
public:
    dxJointReader(const dxIslandStep &step, const dxConstraintPlan &plan) : m_step(step), m_plan(plan) {}

    // Writes the rows of all joints in lanes, the impulses with which they begin, and the number of rows of each pack. Joints may add to the bodies'
    // accumulators, and call the user's message handlers. Returns the number of rows of all joints.
    unsigned read(dxJointLanes *rows) const;

    // Writes the bodies of packs [begin, end). `masses`: by tag.
    void readBodies(unsigned begin, unsigned end, const dxIslandBody *masses) const;

    // The joints of packs [begin, end) keep the forces of the impulses for the next step.
    void keep(const dxJointLanes *rows, unsigned begin, unsigned end) const;

    // Writes the forces of the impulses to the joints' feedback, in the order of joints.
    void giveFeedback(const dxJointLanes *rows) const;

private:
    using LaneJoint = dxConstraintPlan::LaneJoint;

    const LaneJoint &laneJoint(std::size_t pack, unsigned lane) const { return m_plan.laneJoints()[pack * dxLanes::kCount + lane]; }
    dxJoint &jointOf(const LaneJoint &own) const { return *m_step.island.joints[own.joint]; }
    unsigned readPack(std::size_t number, dxJointLanes *rows) const;
    unsigned readJoint(const LaneJoint &own, dxJointLanes *rows, unsigned lane) const;

    const dxIslandStep &m_step;
    const dxConstraintPlan &m_plan;
};
