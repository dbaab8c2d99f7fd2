#include "dynamics/world_step/fast/dxMethodCosts.h"

#include <algorithm>
#include <limits>

#include "dynamics/world_step/fast/dxDirectMemory.h"
#include "dynamics/world_step/fast/dxIslandShape.h"
#include "dynamics/world_step/fast/dxRowBlocks.h"

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The part of the cost of Dantzig's algorithm that another method may have.
constexpr double kEliminationPart = 0.8, kBodySpacePart = 0.92;

// Below so many rows Dantzig's algorithm knows no skyline.
constexpr unsigned kSkylineRows = 64;

// Of an interior point: motors take 8, contacts 13 to 26, those of high stacks and of crowded joints up to 60.
constexpr double kFactorisations = 15, kFactorisationsOfCrowd = 45;

// Rows with limits for each freedom that the others leave to the bodies: walls have 3.4, robots 1 to 2.6, and with 6 rows contradict
// one another.
constexpr double kCrowd = 4;

bool isCrowded(const dxIslandShape &shape) {
    const double freedoms = double(kBodyAxes) * shape.bodies - shape.unlimited();
    return shape.limited > 0 && shape.unlimited() > 0 && shape.limited > kCrowd * freedoms;
}

double makeMatrix(double rows) { return 3e-4 * rows * rows; }

// Dantzig's steps for rows with limits, among themselves.
double driveRows(double limited) { return limited * (0.12 + limited * (2.2e-3 + limited * 3.3e-5)); }

// A factorisation of the rows without limits, then steps for each of the others, which pass over all of that.
double costOfDantzig(const dxIslandShape &shape, double activeShare) {
    if (shape.rows >= kMinDirectRows) return kInfinity;  // no memory for the matrix
    const double unlimited = shape.unlimited(), limited = shape.limited;
    const bool hasSkyline = shape.rows >= kSkylineRows;
    const double elements = hasSkyline ? shape.skyline : unlimited * unlimited / 2;
    const double squares = hasSkyline ? shape.skylineSquares : unlimited * unlimited * unlimited / 3;
    const double factor = 2.2e-3 * elements + 1.8e-5 * squares;
    const double steps = driveRows(limited) + limited * (2.5e-4 * elements + 1.8e-4 * limited * unlimited);
    return 0.1 + 0.17 * shape.joints + makeMatrix(shape.rows) + factor + activeShare * steps;
}

// Blocks are as large as the mean joint's. Rows of A_ul have as many lines as rows with limits fill, since these spread in the elimination.
double costOfElimination(const dxIslandShape &shape) {
    const double limited = shape.rows - shape.eliminatedRows;
    if (shape.eliminatedJoints == 0 || limited >= dxRowBlocks::kMaxLines * kBodyLanes || isCrowded(shape)) return kInfinity;
    const double size = double(shape.eliminatedRows) / shape.eliminatedJoints, block = size * size, lines = limited / kBodyLanes + 1;
    const double rows = 0.3 + 0.045 * shape.joints + 0.055 * shape.rows;
    const double ordering = 0.0125 * shape.blocks + 0.003 * shape.products;  // a quarter of it: the last island's order may do
    const double factor = 0.03 * shape.blocks + (0.0037 + 0.0004 * block) * shape.products;
    const double beside = 0.0008 * shape.blocks * block * lines + 0.0015 * shape.eliminatedRows * lines * (lines + 1);
    return rows + ordering + factor + beside + makeMatrix(limited) + driveRows(limited);
}

// Without limits, one factorisation and its refinement.
double costOfBodySpace(const dxIslandShape &shape) {
    if (shape.limited == 0) return 0.5 * shape.bodies + 0.4 * shape.joints + 0.16 * shape.rows;
    return 0.11 * shape.rows + (isCrowded(shape) ? kFactorisationsOfCrowd : kFactorisations) * (0.33 * shape.bodies + 0.021 * shape.rows);
}

}  // namespace

dxMethodCosts dxMethodCosts::of(const dxIslandShape &shape, double activeShare) {
    return {costOfDantzig(shape, activeShare), costOfElimination(shape), costOfBodySpace(shape)};
}

dxDirectMethod dxMethodCosts::cheapest() const {
    const double withoutEliminated = elimination / kEliminationPart, inBodySpace = bodySpace / kBodySpacePart;
    if (dantzig <= std::min(withoutEliminated, inBodySpace)) return dxDirectMethod::Dantzig;
    return withoutEliminated < inBodySpace ? dxDirectMethod::Elimination : dxDirectMethod::BodySpace;
}
