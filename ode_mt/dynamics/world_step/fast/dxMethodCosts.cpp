#include "dynamics/world_step/fast/dxMethodCosts.h"

#include <algorithm>
#include <limits>

#include "config.h"
#include "objects.h"
#include "joints/joint.h"
#include "util.h"

#include "core/dxNoIndex.h"
#include "dynamics/world_step/dxWorldStepProblem.h"
#include "dynamics/world_step/fast/dxResidual.h"
#include "dynamics/world_step/fast/dxRowBlocks.h"

namespace {

// --- statistics --------------------------------------------------------------------------------------------

constexpr int kPair = dxJoint::GI2__RHS_CFM_MAX;

// Of a body, the joints so far that have bilateral rows.
struct Share {
    unsigned firstRow;  // among bilateral rows; kNoIndex: none
    unsigned joints;
};

// J u of one row.
double findMotion(const dxWorldStepProblem &problem, const dxWorldStepJoint &joint, unsigned row, const dxBodyVector *motions) {
    double sum = 0;
    for (unsigned side = 0; side < dxWorldStepProblem::kSides && joint.joint->node[side].body != nullptr; ++side) {
        const dReal *const elements = problem.rowsOf(joint, side) + std::size_t(row) * dxWorldStepProblem::kElements;
        const dxBodyVector &motion = motions[joint.joint->node[side].body->tag];
        for (unsigned axis = 0; axis < 3; ++axis) {
            sum += elements[axis] * motion.lane[axis];
            sum += elements[3 + axis] * motion.lane[3 + axis];
        }
    }
    return sum;
}

// --- costs -------------------------------------------------------------------------------------------------

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The part of the cost of Dantzig's algorithm that another method may have.
constexpr double kEliminationPart = 0.8, kBodySpacePart = 0.92;

// With fewer rows Dantzig's algorithm uses no skyline.
constexpr unsigned kSkylineRows = 64;

// Of an interior point: motors take 8, contacts 13 to 26, those of high stacks and of crowded joints up to 60.
constexpr double kFactorisations = 15, kFactorisationsOfCrowd = 45;

// Unilateral rows for each freedom that the others leave to the bodies: walls have 3.4, robots 1 to 2.6, and with 6 rows contradict
// one another.
constexpr double kCrowd = 4;

bool isCrowded(const dxLcpStatistics &statistics) {
    const double freedoms = double(kBodyAxes) * statistics.bodies - statistics.bilateralRows();
    return statistics.unilateralRows > 0 && statistics.bilateralRows() > 0 && statistics.unilateralRows > kCrowd * freedoms;
}

double makeMatrix(double rows) { return 3e-4 * rows * rows; }

// Dantzig's steps for unilateral rows, among themselves.
double driveRows(double unilateral) { return unilateral * (0.12 + unilateral * (2.2e-3 + unilateral * 3.3e-5)); }

// A factorisation of the bilateral rows, then steps for each of the others, which pass over all of that.
double costOfDantzig(const dxLcpStatistics &statistics, double activeShare) {
    if (statistics.rows >= kDantzigThreshold) return kInfinity;  // no memory for the matrix
    const double bilateral = statistics.bilateralRows(), unilateral = statistics.unilateralRows;
    const bool hasSkyline = statistics.rows >= kSkylineRows;
    const double elements = hasSkyline ? statistics.skyline : bilateral * bilateral / 2;
    const double squares = hasSkyline ? statistics.skylineSquares : bilateral * bilateral * bilateral / 3;
    const double factor = 2.2e-3 * elements + 1.8e-5 * squares;
    const double steps = driveRows(unilateral) + unilateral * (2.5e-4 * elements + 1.8e-4 * unilateral * bilateral);
    return 0.1 + 0.17 * statistics.joints + makeMatrix(statistics.rows) + factor + activeShare * steps;
}

// Blocks are as large as the mean joint's. Rows of A_ek have as many lines as unilateral rows fill, since these spread in the elimination.
double costOfElimination(const dxLcpStatistics &statistics) {
    const double unilateral = statistics.rows - statistics.eliminatedRows;
    if (statistics.eliminatedJoints == 0 || unilateral >= dxRowBlocks::kMaxLines * kBodyLanes || isCrowded(statistics)) return kInfinity;
    const double size = double(statistics.eliminatedRows) / statistics.eliminatedJoints, block = size * size, lines = unilateral / kBodyLanes + 1;
    const double rows = 0.3 + 0.045 * statistics.joints + 0.055 * statistics.rows;
    const double ordering = 0.0125 * statistics.blocks + 0.003 * statistics.products;  // a quarter of it: the last island's order may do
    const double factor = 0.03 * statistics.blocks + (0.0037 + 0.0004 * block) * statistics.products;
    const double beside = 0.0008 * statistics.blocks * block * lines + 0.0015 * statistics.eliminatedRows * lines * (lines + 1);
    return rows + ordering + factor + beside + makeMatrix(unilateral) + driveRows(unilateral);
}

// Where all rows are bilateral, one factorisation and its refinement.
double costOfBodySpace(const dxLcpStatistics &statistics) {
    if (statistics.unilateralRows == 0) return 0.5 * statistics.bodies + 0.4 * statistics.joints + 0.16 * statistics.rows;
    const double factorisations = isCrowded(statistics) ? kFactorisationsOfCrowd : kFactorisations;
    return 0.11 * statistics.rows + factorisations * (0.33 * statistics.bodies + 0.021 * statistics.rows);
}

}  // namespace

dxLcpStatistics dxLcpStatistics::of(const dxWorldStepProblem &problem, dxWorldProcessMemArena &arena) {
    dxLcpStatistics statistics;
    statistics.bodies = problem.bodyCount;
    statistics.joints = problem.jointCount;
    statistics.rows = problem.rowCount;
    void *const state = arena.SaveState();
    Share *const shares = arena.AllocateArray<Share>(problem.bodyCount);
    std::fill_n(shares, problem.bodyCount, Share{kNoIndex, 0});
    unsigned position = 0;  // among bilateral rows
    for (unsigned i = 0; i < problem.jointCount; ++i) {
        const dxWorldStepJoint &joint = problem.joints[i];
        unsigned first = i < problem.bilateralJoints ? joint.rows : 0u, bilateral = first;
        for (unsigned row = first; row < joint.rows; ++row) {
            const bool isBilateral = problem.isBilateral(std::size_t(joint.firstRow) + row);
            first += isBilateral && bilateral == row;
            bilateral += isBilateral;
        }
        statistics.unilateralRows += joint.rows - bilateral;
        if (first == 0) continue;
        ++statistics.eliminatedJoints;
        statistics.eliminatedRows += first;
        unsigned begin = position;
        for (unsigned side = 0; side < dxWorldStepProblem::kSides && joint.joint->node[side].body != nullptr; ++side) {
            Share &share = shares[joint.joint->node[side].body->tag];
            if (share.firstRow == kNoIndex) share.firstRow = position;
            begin = std::min(begin, share.firstRow);
            statistics.blocks += share.joints;
            statistics.products += double(share.joints) * (share.joints + 1) / 2;
            ++share.joints;
        }
        const double length = position - begin + first;
        statistics.skyline += first * length;
        statistics.skylineSquares += first * length * length;
        position += first;
    }
    arena.RestoreState(state);
    return statistics;
}

double dxFindActiveShare(const dxWorldStepProblem &problem, double stepSize, dxWorldProcessMemArena &arena) {
    void *const state = arena.SaveState();
    auto *const motions = arena.AllocateOveralignedArray<dxBodyVector>(problem.bodyCount, alignof(dxBodyVector));
    dxFindBodyMotions(problem, stepSize, motions);
    unsigned unilateral = 0, active = 0;
    int lastRow = -1;  // of those that push or pull only
    bool isLastActive = true;
    for (unsigned i = 0; i < problem.jointCount; ++i) {
        const dxWorldStepJoint &joint = problem.joints[i];
        for (unsigned row = 0; row < joint.rows; ++row) {
            const std::size_t index = std::size_t(joint.firstRow) + row;
            if (problem.isBilateral(index)) continue;
            ++unilateral;
            const double low = problem.pairsLoHi[index * kPair + dxJoint::GI2_LO], high = problem.pairsLoHi[index * kPair + dxJoint::GI2_HI];
            bool isActive = true;
            if (problem.normalOf[index] != -1) {
                isActive = problem.normalOf[index] != lastRow || isLastActive;
            } else if ((low == 0) != (high == 0)) {
                const double b = problem.pairsBX[index * kPair + dxJoint::GI2_RHS] - findMotion(problem, joint, row, motions);
                isActive = low == 0 ? b > 0 : b < 0;
                lastRow = static_cast<int>(index);
                isLastActive = isActive;
            }
            active += isActive;
        }
    }
    arena.RestoreState(state);
    return unilateral > 0 ? double(active) / unilateral : 0;
}

dxMethodCosts dxMethodCosts::of(const dxLcpStatistics &statistics, double activeShare) {
    return {costOfDantzig(statistics, activeShare), costOfElimination(statistics), costOfBodySpace(statistics)};
}

dxWorldStepMethod dxMethodCosts::cheapest() const {
    const double withoutEliminated = elimination / kEliminationPart, inBodySpace = bodySpace / kBodySpacePart;
    if (dantzig <= std::min(withoutEliminated, inBodySpace)) return dxWorldStepMethod::Dantzig;
    return withoutEliminated < inBodySpace ? dxWorldStepMethod::Elimination : dxWorldStepMethod::BodySpace;
}
