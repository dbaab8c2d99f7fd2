#include "dynamics/world_step/fast/dxBilateralSolver.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "core/dxNoIndex.h"
#include "dynamics/step/islands/dxIslandStep.h"
#include "dynamics/world_step/dxWorldStepProblem.h"
#include "dynamics/world_step/fast/dxResidual.h"

namespace {

constexpr int kPair = dxJoint::GI2__RHS_CFM_MAX;

dxBilateralJoint describe(const dxWorldStepJoint &joint) {
    const dxBody *const second = joint.joint->node[dJCB_SECOND_BODY].body;
    return {{static_cast<unsigned>(joint.joint->node[dJCB_FIRST_BODY].body->tag),
             second != nullptr ? static_cast<unsigned>(second->tag) : kNoIndex},
            joint.rows, joint.joint->type() == dJointTypeBall};
}

// Calls work(rows), the number of most bilateral joints being a constant in it: loops are unrolled.
template <class Work>
void withRows(unsigned rows, const Work &work) {
    rows == 3 ? work(std::integral_constant<unsigned, 3>()) : work(rows);
}

// A joint's rows as columns, a lane each.
template <class Count>
void transpose(const dReal *rows, Count count, double *columns) {
    for (unsigned row = 0; row < count; ++row)
        for (unsigned k = 0; k < kBodyAxes; ++k) columns[k * kBodyLanes + row] = rows[row * dxWorldStepProblem::kElements + k];
}

// Of a ball joint the angular part.
void transposeBall(const dReal *rows, double *columns) {
    for (unsigned k = 3; k < kBodyAxes; ++k)
        for (unsigned row = 0; row < 3; ++row)
            columns[k * dxBilateralSystem::kBallLanes + row] = rows[row * dxWorldStepProblem::kElements + k];
}

}  // namespace

bool dxBilateralSolver::solve(const dxIslandStep &step, const dxWorldStepProblem &problem) {
    if (!isOrdered(problem)) order(problem);
    return solveOrdered(step, problem);
}

bool dxBilateralSolver::solveKnown(const dxIslandStep &step, const dxWorldStepProblem &problem) {
    return isOrdered(problem) && solveOrdered(step, problem);
}

bool dxBilateralSolver::solveOrdered(const dxIslandStep &step, const dxWorldStepProblem &problem) {
    if (!readRows(problem)) return false;
    m_inverseMasses.resize(problem.bodyCount);
    m_motions.resize(problem.bodyCount);
    dxFindInverseMasses(problem, m_inverseMasses.data());
    dxFindBodyMotions(problem, step.stepSize, m_motions.data(), dxPerStep::Product);
    if (!m_system.solve(step.runner(), m_inverseMasses.data(), m_motions.data())) return false;
    findAccelerations(problem);
    if (!isGood(problem)) return false;
    writeForces(problem);
    return true;
}

bool dxBilateralSolver::applyForces(const dxWorldStepProblem &problem) const {
    const auto hasFeedback = [](const dxWorldStepJoint &joint) { return joint.joint->feedback != nullptr; };
    if (std::any_of(problem.joints, problem.joints + problem.jointCount, hasFeedback)) return false;
    for (unsigned i = 0; i < problem.bodyCount; ++i) {
        dxBody &body = *problem.bodies[i];
        for (unsigned axis = 0; axis < 3; ++axis) {
            body.facc[axis] += static_cast<dReal>(m_bodyForces[i].lane[axis]);
            body.tacc[axis] += static_cast<dReal>(m_bodyForces[i].lane[3 + axis]);
        }
    }
    return true;
}

bool dxBilateralSolver::isOrdered(const dxWorldStepProblem &problem) const {
    if (m_joints.size() != problem.jointCount || m_bodyCount != problem.bodyCount) return false;
    for (unsigned i = 0; i < problem.jointCount; ++i) {
        const dxBilateralJoint joint = describe(problem.joints[i]), &known = m_joints[i];
        if (joint.bodies[0] != known.bodies[0] || joint.bodies[1] != known.bodies[1] || joint.rows != known.rows ||
            joint.isBall != known.isBall)
            return false;
    }
    return true;
}

void dxBilateralSolver::order(const dxWorldStepProblem &problem) {
    m_bodyCount = 0;
    m_joints.clear();
    m_system.isBalls = true;
    for (unsigned i = 0; i < problem.jointCount; ++i) {
        m_joints.push_back(describe(problem.joints[i]));
        m_system.isBalls &= m_joints.back().isBall;
    }
    pairSides(problem.bodyCount);
    m_system.takeMemory();
    m_bodyCount = problem.bodyCount;
}

// Each side of a joint with those before it on the same body. Joints have the island's numbers yet.
void dxBilateralSolver::pairSides(unsigned bodyCount) {
    dxBilateralSystem &system = m_system;
    const auto count = static_cast<unsigned>(m_joints.size());
    m_first.assign(bodyCount, kNoIndex);
    m_next.assign(std::size_t(2) * count, kNoIndex);
    m_edges.clear();
    m_sides.clear();
    for (unsigned later = 0; later < 2 * count; ++later) {
        const unsigned body = m_joints[later / 2].bodies[later % 2];
        if (body == kNoIndex) continue;
        for (unsigned earlier = m_first[body]; earlier != kNoIndex; earlier = m_next[earlier]) {
            m_sides.emplace_back(later, earlier);
            m_edges.emplace_back(earlier / 2, later / 2);
        }
        m_next[later] = m_first[body];
        m_first[body] = later;
    }
    system.order.find(count, m_edges);

    const auto placeOf = [&](unsigned side) { return system.order.placeOf(side / 2); };
    m_blockPairs.clear();
    for (auto [a, b] : m_sides) {
        if (placeOf(a) > placeOf(b)) std::swap(a, b);  // the first one is eliminated first
        m_blockPairs.push_back({system.order.findBlock(placeOf(b), placeOf(a)), {a % 2, 2 * placeOf(b) + b % 2}});
    }
    std::sort(m_blockPairs.begin(), m_blockPairs.end(), [](const auto &a, const auto &b) {
        return std::make_pair(a.first, a.second.other) < std::make_pair(b.first, b.second.other);
    });
    system.firstPair.assign(system.order.blockCount() + std::size_t(1), 0);
    system.pairs.clear();
    for (const auto &[block, pair] : m_blockPairs) {
        ++system.firstPair[block + 1];
        system.pairs.push_back(pair);
    }
    for (unsigned block = 0; block < system.order.blockCount(); ++block) system.firstPair[block + 1] += system.firstPair[block];

    system.joints.resize(count);
    for (unsigned i = 0; i < count; ++i) system.joints[system.order.placeOf(i)] = m_joints[i];
}

// Returns false where cfm is negative. One that is no number makes the residual none.
bool dxBilateralSolver::readRows(const dxWorldStepProblem &problem) {
    dReal leastCfm = 0;
    for (unsigned i = 0; i < problem.jointCount; ++i) {
        const dxWorldStepJoint &joint = problem.joints[i];
        const unsigned place = m_system.order.placeOf(i), sides = m_system.joints[place].bodies[1] != kNoIndex ? 2 : 1;
        double *const given = m_system.vectorOf(place, dxBilateralSystem::kGiven);
        double *const softness = m_system.vectorOf(place, dxBilateralSystem::kSoftness);
        const dReal *const pairs = problem.pairsBX + std::size_t(joint.firstRow) * kPair;
        withRows(joint.rows, [&](auto rows) {
            for (unsigned side = 0; side < sides; ++side) {
                const dReal *const from = problem.rowsOf(joint, side);
                double *const to = m_system.jacobianOf(place, side);
                m_system.isBalls ? transposeBall(from, to) : transpose(from, rows, to);
            }
            for (unsigned row = 0; row < rows; ++row) {
                const dReal cfm = pairs[row * kPair + dxJoint::GI2_CFM];
                given[row] = pairs[row * kPair + dxJoint::GI2_RHS];
                softness[row] = cfm;
                leastCfm = std::min(leastCfm, cfm);
            }
        });
    }
    return leastCfm == 0;
}

// inv(M) J' x + v/h + inv(M) f
void dxBilateralSolver::findAccelerations(const dxWorldStepProblem &problem) {
    m_bodyForces.assign(problem.bodyCount, dxBodyVector{});
    m_accelerations.resize(problem.bodyCount);
    for (unsigned i = 0; i < problem.jointCount; ++i) {
        const dxWorldStepJoint &joint = problem.joints[i];
        const unsigned place = m_system.order.placeOf(i);
        const double *const forces = m_system.vectorOf(place, dxBilateralSystem::kForce);
        const unsigned *const bodies = m_system.joints[place].bodies;
        withRows(joint.rows, [&](auto rows) {
            for (unsigned side = 0; side < 2 && bodies[side] != kNoIndex; ++side)
                dxAddForces(problem.rowsOf(joint, side), rows, forces, m_bodyForces[bodies[side]]);
        });
    }
    for (unsigned i = 0; i < problem.bodyCount; ++i) m_accelerations[i] = dxAccelerate(m_inverseMasses[i], m_bodyForces[i], m_motions[i]);
}

bool dxBilateralSolver::isGood(const dxWorldStepProblem &problem) {
    const dxBilateralSizes sizes = m_system.findResidual(m_accelerations.data());
    return std::isfinite(sizes.residual) &&
           dxIsGoodResidual(kEliminationBound, sizes.residual, m_system.largestB, sizes.sum, problem, m_motions.data());
}

void dxBilateralSolver::writeForces(const dxWorldStepProblem &problem) {
    for (unsigned i = 0; i < problem.jointCount; ++i) {
        const dxWorldStepJoint &joint = problem.joints[i];
        const double *const forces = m_system.vectorOf(m_system.order.placeOf(i), dxBilateralSystem::kForce);
        dReal *const pairs = problem.pairsBX + std::size_t(joint.firstRow) * kPair;
        withRows(joint.rows, [&](auto rows) {
            for (unsigned row = 0; row < rows; ++row) pairs[row * kPair + dxJoint::GI2_CFM] = static_cast<dReal>(forces[row]);
        });
    }
}
