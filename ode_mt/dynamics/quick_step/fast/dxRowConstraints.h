// Constraints that are solved in rows rather than lanes: joints (hinges, motors), and contacts that fill no lanes or roll. The rows are QuickStep's
// (dxConstraintRow), with velocities and impulses in place of accelerations and forces.
//
// Contacts begin with forces of the last step, other joints without any (docs/fast.md, "Other joints").
//
// Threading: serial, but for the functions that take joints [begin, end) of a chunk of the plan, which several threads may call for chunks of
// one phase.
#pragma once

#include <optional>

#include "dynamics/quick_step/dxJointRows.h"
#include "dynamics/quick_step/fast/dxConstraintPlan.h"
#include "dynamics/quick_step/fast/dxRowOrder.h"
#include "dynamics/step/islands/dxIslandProblem.h"
#include "dynamics/step/islands/dxIslandStep.h"

// The joints of a group that are solved in rows, and their rows as the joints write them.
class dxRowJoints {
public:
    // Asks the joints for their rows. Takes memory of the step's arena, in which upstream's estimate has room for it. May call
    // the user's message handlers.
    dxRowJoints(const dxIslandStep &step, const dxConstraintPlan &plan);

    dxConstraintRow *rows() const { return m_rows; }
    unsigned rowCount() const { return m_reader ? m_reader->rowCount() : 0; }

    // Calls visit(joint, its first row, number of rows) for those that have any, in the order of the group.
    template <class Visit>
    void forJoints(const Visit &visit) const {
        if (m_reader) m_reader->forJoints(visit);
    }

    // Requires forces in the rows' lambda.
    void giveFeedback() const {
        if (m_reader) m_reader->giveFeedback(m_rows);
    }

private:
    dxIslandStep m_step;  // of these joints only
    std::optional<dxJointRows> m_reader;
    dxConstraintRow *m_rows = nullptr;
};

class dxRowConstraints {
public:
    // Takes the memory that the plan's joints may need, however many rows they have. Throws std::bad_alloc.
    void reserve(const dxConstraintPlan &plan, dxStepArena &arena);

    // prepare(), apply() and sweep() write an energy for each joint, and return the sum: the energy that the kernel for contacts writes, too
    // (dxContactSweep.h).

    // Takes the rows of `joints` as these have written them.
    void begin(const dxRowJoints &joints, const dxConstraintPlan &plan);

    // Contacts start with impulses of the last step. Requires begin().
    void startWarm(const dxIslandStep &step);

    // Completes the rows. `velocities`: the free ones; `factor`: the over-relaxation of the sweeps.
    double prepare(const dxRowJoints &joints, const dxIslandBody *bodies, unsigned bodyCount, dxSpatialMotion *velocities, dReal stepSize,
                   dReal factor);

    // Adds the impulses of joints [begin, end) to the velocities of their bodies.
    double apply(unsigned begin, unsigned end, dxSpatialMotion *velocities);

    // Relaxes each row once. `sweep`: its number, from 1. `isMeasured`: finds energies, of the change since the last sweep in which they
    // were found; that reads each row again.
    double sweep(unsigned begin, unsigned end, dxSpatialMotion *velocities, unsigned sweep, bool isMeasured);

    // Whether rows bound others. Requires prepare().
    bool hasFriction() const { return m_hasFriction; }

    // By joint in the order of the group.
    dxArenaArray<const double> energies() const { return m_energies; }

    // A joint, in the order of the group, begins without forces. Requires that its bodies move freely.
    void startCold(unsigned joint);

    // Rows are no longer over-relaxed: those of joints [begin, end); those of the group that others bound, which requires a factor above 1.
    void endOverRelaxation(unsigned begin, unsigned end);
    void endOverRelaxationOfFriction();

    // Leaves the forces of contacts in the warm-start cache. Requires dxContactReader::list() and impulses in the rows.
    void keep(const dxIslandStep &step) const;

    // Leaves forces in the rows' lambda.
    void finish(dReal stepSize);

private:
    // The direction of a row's force on body A.
    struct Direction {
        dReal axis[3];
    };

    void findRows(const dxRowJoints &joints);
    void startContact(unsigned joint, const dReal *impulse);
    void findContactImpulse(unsigned joint, dReal *impulse) const;
    double prepareRow(dxConstraintRow &row, const dxIslandBody *bodies, const dxSpatialMotion *velocities, dReal stepSize,
                      dReal &diagonal);
    void endOverRelaxation(dxConstraintRow &row);
    double applyRow(unsigned index, dxSpatialMotion *velocities) const;
    template <class EnergyOf>
    double forJoints(unsigned begin, unsigned end, const EnergyOf &energyOf);

    const dxConstraintPlan *m_plan = nullptr;
    dxConstraintRow *m_rows = nullptr;
    unsigned m_rowCount = 0;
    dReal m_factor = 1;
    bool m_isFrictionRelaxed = false, m_hasFriction = false;
    dxRowOrder m_order;
    dxArenaArray<unsigned> m_firstRow;     // by joint in the order of the group, and the end
    dxArenaArray<double> m_energies;       // by joint in the order of the group
    dxArenaArray<Direction> m_directions;  // by row, of contacts
    dxArenaArray<dReal> m_diagonal;        // by row: J inv(M) J' + softness
    dxArenaArray<dReal> m_last;            // by row: the impulse when energies were found last
};
