// Rows of joints that are not solved as lanes: as QuickStep's (dxConstraintRow), but with velocities and impulses for
// accelerations and forces. One block is the rows of a joint, which are solved one after the other.
#pragma once

#include <vector>

#include "dynamics/iterative/dxConstraintPlan.h"
#include "dynamics/iterative/dxOtherJoints.h"
#include "dynamics/iterative/dxVelocities.h"

struct dxIslandBody;

class dxOtherRows {
public:
    // Takes the memory that the plan's joints may need, whatever they say. Throws std::bad_alloc.
    void reserve(const dxConstraintPlan &plan);

    // Takes as much memory as others have. Throws std::bad_alloc.
    void reserveAs(const dxOtherRows &other);

    // All that follow write an energy for each joint, and return the sum of them: the one that kernels over contacts write
    // (dxContactSweep.h).

    // Completes the rows of `joints`, `velocities` being the free ones; sweeps over-relax by `factor`.
    double prepare(const dxOtherJoints &joints, const dxConstraintPlan &plan, const dxIslandBody *bodies,
                   const dxVelocity *velocities, dReal stepSize, dReal factor, bool isWarm);

    // Joints [begin, end) of the plan's by colour. Reads and writes the velocities of their bodies.
    double apply(unsigned begin, unsigned end, dxVelocity *velocities);
    double sweep(unsigned begin, unsigned end, dxVelocity *velocities);

    // By joint in the order of the group.
    const std::vector<double> &energies() const { return m_energies; }

    // A joint, in the order of the group, starts without forces. Requires that its bodies move freely.
    void startCold(unsigned joint);

    // From now on friction is not over-relaxed.
    void relaxFriction();

    // Keeps the forces in the joints and in the rows' lambda.
    void finish(const dxOtherJoints &joints, dReal stepSize);

private:
    void orderRows(const dxOtherJoints &joints, const dxConstraintPlan &plan);
    double prepareRow(dxConstraintRow &row, const dxIslandBody *bodies, const dxVelocity *velocities, dReal stepSize,
                      dReal &diagonal) const;
    double push(int index, dxVelocity *velocities) const;
    template <class EnergyOf>
    double forJoints(unsigned begin, unsigned end, const EnergyOf &energyOf);

    const dxConstraintPlan *m_plan = nullptr;
    dxConstraintRow *m_rows = nullptr;
    dReal m_factor = 1;
    std::vector<int> m_order;              // of rows, by colour
    std::vector<unsigned> m_firstInOrder;  // by joint by colour, and the end
    std::vector<unsigned> m_firstRow;      // by joint in the order of the group, and the end
    std::vector<double> m_energies;
    std::vector<dReal> m_diagonal;         // by row: J inv(M) J' + softness
    std::vector<dReal> m_last;             // by place in the order: the impulse before a sweep
};
