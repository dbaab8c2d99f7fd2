#include "dynamics/world_step/fast/dxEliminatedLcp.h"

#include <algorithm>
#include <cmath>

#include "core/dxNoIndex.h"
#include "dynamics/step/islands/dxIslandStep.h"
#include "dynamics/world_step/dxWorldStepProblem.h"
#include "dynamics/world_step/exact/dxDantzig.h"
#include "dynamics/world_step/fast/dxResidual.h"

namespace {

constexpr int kPair = dxJoint::GI2__RHS_CFM_MAX;

// The largest sum, as part of the largest b, where there are unilateral rows: those that contradict one another have forces of b/c, and which
// of them end at a limit is a matter of rounding. Up to the second one, forces tell whether they do: by what part of b/c they are. A robot of
// twenty modules has 2e4 and 2e-4.
constexpr double kMaxSum = 1e4, kMaxHarmlessSum = 1e5, kMaxPart = 1e-3;

}  // namespace

bool dxEliminatedLcp::solve(const dxIslandStep &step, const dxWorldStepProblem &problem) {
    if (!listParts(problem)) return false;
    pairParts(problem);
    orderJoints();
    shapeBlocks();
    if (!fillRightSide(problem)) return false;
    makeMatrix(problem, step.stepSize);
    if (!dxEliminateRows(m_blocks) || !solveUnilateralRows(step, problem)) return false;
    findForces();
    if (!isGood(problem)) return false;
    writeForces(problem);
    return true;
}

// A joint's first rows are bilateral, if any are. Others count as unilateral rows with infinite limits.
bool dxEliminatedLcp::listParts(const dxWorldStepProblem &problem) {
    m_blocks.parts.clear();
    m_blocks.unilateralCount = m_joints = 0;
    m_unilateralRows.clear();
    m_numberOf.assign(problem.rowCount, kNoIndex);
    for (unsigned i = 0; i < problem.jointCount; ++i) {
        const dxWorldStepJoint &joint = problem.joints[i];
        unsigned bilateral = 0;
        while (bilateral < joint.rows && problem.isBilateral(joint.firstRow + bilateral)) ++bilateral;
        if (bilateral > 0) addPart(problem, i, 0, bilateral, false);
        if (bilateral < joint.rows) addPart(problem, i, bilateral, joint.rows, true);
    }
    return m_joints > 0 && m_blocks.unilateralCount < dxRowBlocks::kMaxLines * kBodyLanes;
}

void dxEliminatedLcp::addPart(const dxWorldStepProblem &problem, unsigned index, unsigned begin, unsigned end, bool isUnilateral) {
    const dxWorldStepJoint &joint = problem.joints[index];
    dxRowPart part{{kNoIndex, kNoIndex}, joint.firstRow + begin, end - begin, isUnilateral, isUnilateral ? m_blocks.unilateralCount : m_joints};
    const std::size_t number = m_blocks.parts.size();
    if (m_blocks.jacobian.size() < 2 * (number + 1)) {
        m_blocks.jacobian.resize(2 * (number + 1));
        m_blocks.byMass.resize(2 * (number + 1));
    }
    for (unsigned side = 0; side < 2; ++side) {
        const dxBody *const body = joint.joint->node[side].body;
        if (body == nullptr) break;
        part.bodies[side] = static_cast<unsigned>(body->tag);
        dxBodyBlock &rows = m_blocks.jacobian[2 * number + side];
        rows = {};
        const dReal *elements = problem.rowsOf(joint, side) + std::size_t(begin) * dxWorldStepProblem::kElements;
        for (unsigned row = 0; row < part.rows; ++row, elements += dxWorldStepProblem::kElements)
            for (unsigned k = 0; k < kBodyAxes; ++k) rows.column[k].lane[row] = elements[k];
    }
    m_blocks.parts.push_back(part);
    if (!isUnilateral) {
        ++m_joints;
        return;
    }
    for (unsigned row = part.firstRow; row < part.firstRow + part.rows; ++row) {
        m_numberOf[row] = m_blocks.unilateralCount++;
        m_unilateralRows.push_back(row);
    }
}

// Each part-side with those before it on the same body. Places are numbers of joints yet.
void dxEliminatedLcp::pairParts(const dxWorldStepProblem &problem) {
    m_first.assign(problem.bodyCount, kNoIndex);
    m_next.resize(2 * m_blocks.parts.size());
    m_blocks.pairs.clear();
    m_edges.clear();
    for (unsigned later = 0; later < 2 * m_blocks.parts.size(); ++later) {
        const dxRowPart &part = m_blocks.parts[later / 2];
        const unsigned body = part.bodies[later % 2];
        if (body == kNoIndex) continue;
        m_next[later] = m_first[body];
        m_first[body] = later;
        for (unsigned earlier = later; earlier != kNoIndex; earlier = m_next[earlier]) {
            m_blocks.pairs.emplace_back(later, earlier);
            const dxRowPart &other = m_blocks.parts[earlier / 2];
            if (!part.isUnilateral && !other.isUnilateral && part.place != other.place) m_edges.emplace_back(other.place, part.place);
        }
    }
}

// Joints of the island before, in most cases: a robot's, and those of others like it.
void dxEliminatedLcp::orderJoints() {
    if (m_orderedJoints != m_joints || m_orderedEdges != m_edges) {
        m_orderedJoints = 0;
        m_blocks.order.find(m_joints, m_edges);
        m_orderedEdges = m_edges;
        m_orderedJoints = m_joints;
    }
    m_blocks.sizes.resize(m_joints);
    for (dxRowPart &part : m_blocks.parts) {
        if (part.isUnilateral) continue;
        part.place = m_blocks.order.placeOf(part.place);
        m_blocks.sizes[part.place] = part.rows;
    }
}

void dxEliminatedLcp::shapeBlocks() {
    dxRowBlocks &blocks = m_blocks;
    blocks.lines = blocks.unilateralCount / kBodyLanes + 1;
    blocks.diagonal.assign(m_joints, dxBodyBlock{});
    blocks.below.assign(blocks.order.blockCount(), dxBodyBlock{});
    blocks.inversePivots.resize(std::size_t(kBodyAxes) * m_joints);
    blocks.slotOf.resize(m_joints);
    blocks.beside.assign(std::size_t(kBodyAxes) * m_joints * blocks.lines + 1, dxBodyVector{});
    blocks.masks.assign(m_joints, std::uint64_t(1) << blocks.unilateralCount / kBodyLanes);
    blocks.unilateralRows.assign(std::size_t(blocks.unilateralCount + 1) * blocks.lines + 1, dxBodyVector{});
}

// c/h and cfm/h.
bool dxEliminatedLcp::fillRightSide(const dxWorldStepProblem &problem) {
    for (const dxRowPart &part : m_blocks.parts)
        for (unsigned i = 0; i < part.rows; ++i) {
            const dReal *const pair = problem.pairsBX + std::size_t(part.firstRow + i) * kPair;
            const double b = pair[dxJoint::GI2_RHS], softness = pair[dxJoint::GI2_CFM];
            if (!(softness >= 0)) return false;
            if (part.isUnilateral) {
                const unsigned number = part.place + i;
                dxElement(m_blocks.unilateralRow(number), number) = softness;
                dxElement(m_blocks.unilateralRow(m_blocks.unilateralCount), number) = b;
            } else {
                m_blocks.diagonal[part.place].column[i].lane[i] = softness;
                dxElement(m_blocks.besideOf(part.place, i), m_blocks.unilateralCount) = b;
            }
        }
    return true;
}

void dxEliminatedLcp::makeMatrix(const dxWorldStepProblem &problem, double stepSize) {
    m_motions.resize(problem.bodyCount);
    dxFindBodyMotions(problem, stepSize, m_motions.data());
    m_inverseMasses.resize(problem.bodyCount);
    dxFindInverseMasses(problem, m_inverseMasses.data());
    dxMakeRowMatrix(m_blocks, m_inverseMasses.data(), m_motions.data());
    for (std::vector<double> *array : {&m_forces, &m_low, &m_high, &m_b, &m_diagonal}) array->resize(problem.rowCount);
    for (const dxRowPart &part : m_blocks.parts)
        for (unsigned i = 0; i < part.rows; ++i) {
            const unsigned row = part.firstRow + i, number = part.place + i;
            m_low[row] = -dInfinity;
            m_high[row] = dInfinity;
            m_b[row] = part.isUnilateral ? dxElement(m_blocks.unilateralRow(m_blocks.unilateralCount), number)
                                      : dxElement(m_blocks.besideOf(part.place, i), m_blocks.unilateralCount);
            m_diagonal[row] = part.isUnilateral ? dxElement(m_blocks.unilateralRow(number), number)
                                             : m_blocks.diagonal[part.place].column[i].lane[i];
        }
}

// Writes their forces, for dxSubstituteBack.
bool dxEliminatedLcp::solveUnilateralRows(const dxIslandStep &step, const dxWorldStepProblem &problem) {
    const unsigned unilateral = m_blocks.unilateralCount;
    m_unilateralForces.assign(m_blocks.lines, dxBodyVector{});
    dxElement(m_unilateralForces.data(), unilateral) = -1;
    if (unilateral == 0) return true;
    dxWorldProcessMemArena &arena = *step.arena;
    void *const state = arena.SaveState();
    dReal *const matrix = arena.AllocateOveralignedArray<dReal>(std::size_t(unilateral) * dPAD(unilateral), kCacheLine);
    dReal *const pairsBX = arena.AllocateArray<dReal>(std::size_t(unilateral) * kPair);
    dReal *const pairsLoHi = arena.AllocateArray<dReal>(std::size_t(unilateral) * kPair);
    int *const normalOf = arena.AllocateArray<int>(unilateral);
    for (unsigned i = 0; i < unilateral; ++i) {
        const unsigned row = m_unilateralRows[i];
        std::copy_n(m_blocks.unilateralRow(i)->lane, i + 1, matrix + std::size_t(i) * dPAD(unilateral));
        pairsBX[i * kPair + dxJoint::GI2_RHS] = static_cast<dReal>(dxElement(m_blocks.unilateralRow(unilateral), i));
        std::copy_n(problem.pairsLoHi + std::size_t(row) * kPair, kPair, pairsLoHi + std::size_t(i) * kPair);
        normalOf[i] = problem.normalOf[row] != -1 ? static_cast<int>(m_numberOf[problem.normalOf[row]]) : -1;
    }
    const bool isSolved = dxTryDantzig(step.islandWorkers, &arena, unilateral, matrix, pairsBX, pairsLoHi, normalOf);
    for (unsigned i = 0; i < unilateral && isSolved; ++i) {
        dxElement(m_unilateralForces.data(), i) = pairsBX[i * kPair + dxJoint::GI2_CFM];
        m_low[m_unilateralRows[i]] = pairsLoHi[i * kPair + dxJoint::GI2_LO];
        m_high[m_unilateralRows[i]] = pairsLoHi[i * kPair + dxJoint::GI2_HI];
    }
    arena.RestoreState(state);
    return isSolved;
}

// By row.
void dxEliminatedLcp::findForces() {
    m_bilateralForces.assign(m_joints, dxBodyVector{});
    dxSubstituteBack(m_blocks, m_unilateralForces.data(), m_bilateralForces);
    for (const dxRowPart &part : m_blocks.parts)
        for (unsigned i = 0; i < part.rows; ++i)
            m_forces[part.firstRow + i] =
                part.isUnilateral ? dxElement(m_unilateralForces.data(), part.place + i) : m_bilateralForces[part.place].lane[i];
}

bool dxEliminatedLcp::isContradictory(const dxWorldStepProblem &problem, double largestB, double largestSum) const {
    if (largestSum <= kMaxSum * largestB) return false;
    double softness = 1;
    for (unsigned row = 0; row < problem.rowCount; ++row)
        softness = std::min(softness, problem.pairsBX[std::size_t(row) * kPair + dxJoint::GI2_CFM] / m_diagonal[row]);
    return largestSum > std::min(kMaxHarmlessSum, kMaxPart / softness) * largestB;
}

bool dxEliminatedLcp::isGood(const dxWorldStepProblem &problem) {
    m_w.resize(problem.rowCount);
    m_accelerations.resize(problem.bodyCount);
    dxFindRowResidual(problem, m_inverseMasses.data(), m_motions.data(), m_forces.data(), m_accelerations.data(), m_w.data());
    dxWorstResidual worst;
    double largestB = 0, largestSum = 0;
    for (unsigned row = 0; row < problem.rowCount; ++row) {
        const double x = dxSnapToLimit(m_forces[row], m_low[row], m_high[row]);
        worst.add(dxKktResidual(x, m_w[row], m_low[row], m_high[row]), m_w[row]);
        largestB = std::max(largestB, std::fabs(m_b[row]));
        largestSum = std::max(largestSum, m_diagonal[row] * std::fabs(m_forces[row]));
    }
    if (!std::isfinite(worst.get()) || (m_blocks.unilateralCount > 0 && isContradictory(problem, largestB, largestSum))) return false;
    return dxIsGoodResidual(kEliminationBound, worst.get(), largestB, largestSum, problem, m_motions.data());
}

void dxEliminatedLcp::writeForces(const dxWorldStepProblem &problem) const {
    for (unsigned row = 0; row < problem.rowCount; ++row)
        problem.pairsBX[std::size_t(row) * kPair + dxJoint::GI2_CFM] = static_cast<dReal>(m_forces[row]);
}
