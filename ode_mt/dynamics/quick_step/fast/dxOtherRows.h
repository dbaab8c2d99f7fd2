// Rows of joints that are not solved as lanes: as QuickStep's (dxConstraintRow), but with velocities and impulses for
// accelerations and forces.
//
// Joints begin without forces, contacts with those of the last step (docs/iterative-solver.md, "Other joints").
#pragma once

#include <vector>

#include "dynamics/quick_step/fast/dxConstraintPlan.h"
#include "dynamics/quick_step/fast/dxOtherJoints.h"
#include "dynamics/quick_step/fast/dxRowOrder.h"
#include "dynamics/quick_step/fast/dxVelocities.h"

struct dxIslandBody;

class dxOtherRows {
public:
    // Takes the memory that the plan's joints may need, whatever they say. Throws std::bad_alloc.
    void reserve(const dxConstraintPlan &plan);

    // Takes as much memory as others have. Throws std::bad_alloc.
    void reserveAs(const dxOtherRows &other);

    // All that follow write an energy for each joint, and return the sum of them: the one that kernels over contacts write
    // (dxContactSweep.h).

    // Takes the rows of `joints` as they have written them.
    void begin(const dxOtherJoints &joints, const dxConstraintPlan &plan);

    // A contact, by its number in the order of the group, starts with an impulse along the world's axes. After begin().
    void startContact(unsigned joint, const dReal *impulse);

    // Completes the rows, `velocities` being the free ones; sweeps over-relax by `factor`.
    double prepare(const dxOtherJoints &joints, const dxIslandBody *bodies, unsigned bodyCount, dxVelocity *velocities, dReal stepSize,
                   dReal factor);

    // Joints [begin, end) of a chunk of the plan, or of several. Reads and writes the velocities of their bodies.
    double apply(unsigned begin, unsigned end, dxVelocity *velocities);
    // `sweep`: its number, from 1. `isMeasured`: finds energies, of the change since the last sweep in which they were found. That takes
    // a look at each row.
    double sweep(unsigned begin, unsigned end, dxVelocity *velocities, unsigned sweep, bool isMeasured);

    // Whether rows bound others. After prepare().
    bool hasFriction() const { return m_hasFriction; }

    // By joint in the order of the group.
    const std::vector<double> &energies() const { return m_energies; }

    // A joint, in the order of the group, begins without forces. Requires that its bodies move freely.
    void startCold(unsigned joint);

    // From now on rows are not over-relaxed; of the second kind those that others bound, which requires a factor above 1.
    void relax(unsigned begin, unsigned end);
    void relaxFriction();

    // What a contact's rows have found, along the world's axes.
    void findContactImpulse(unsigned joint, dReal *impulse) const;

    // Leaves forces in the rows' lambda.
    void finish(dReal stepSize);

private:
    // Of the force on the first body.
    struct Direction {
        dReal axis[3];
    };

    void findRows(const dxOtherJoints &joints);
    void noteDirections(unsigned begin, unsigned end);
    double prepareRow(dxConstraintRow &row, const dxIslandBody *bodies, const dxVelocity *velocities, dReal stepSize,
                      dReal &diagonal);
    void relaxRow(dxConstraintRow &row);
    double push(unsigned index, dxVelocity *velocities) const;
    template <class EnergyOf>
    double forJoints(unsigned begin, unsigned end, const EnergyOf &energyOf);

    const dxConstraintPlan *m_plan = nullptr;
    dxConstraintRow *m_rows = nullptr;
    dReal m_factor = 1;
    bool m_isFrictionRelaxed = false, m_hasFriction = false;
    dxRowOrder m_order;
    std::vector<unsigned> m_firstRow;      // by joint in the order of the group, and the end
    std::vector<double> m_energies;
    std::vector<Direction> m_directions;   // by row, of contacts
    std::vector<dReal> m_diagonal;         // by row: J inv(M) J' + softness
    std::vector<dReal> m_last;             // by row: the impulse when energies were found last
};
