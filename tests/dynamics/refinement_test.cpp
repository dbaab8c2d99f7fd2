// The last digits: from a guess of which rows are at a limit on, a solution is corrected to a residual of rounding, and rows that were guessed
// on the wrong side change it.
#include "dynamics/world_step/fast/dxRefinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "dynamics/world_step/fast/dxInteriorPoint.h"
#include "random_body_space_problem.h"

namespace {

// A problem, solved, whose states of rows are those of the solution.
struct SolvedProblem {
    explicit SolvedProblem(unsigned seed) : random({40, 80, 3, 1e-6}, seed) {
        interior.begin(random.problem, random.order, phases, 1);
        interior.low() = random.problem.lo;
        interior.high() = random.problem.hi;
        residual = interior.solve();
        low = random.problem.lo;
        high = random.problem.hi;
        x = interior.x();
        for (std::vector<double> *array : {&low, &high, &x}) array->resize(dxProblemChunks::padded(random.problem.rowCount));
        for (unsigned i = 0; i < x.size(); ++i)
            state.push_back(x[i] <= low[i] ? dxRowState::AtLow : x[i] >= high[i] ? dxRowState::AtHigh : dxRowState::Free);
        system.begin(random.problem, random.order, phases, 1);
        refinement.begin(random.problem);
    }

    // Returns the residual.
    double refine() { return refinement.refine(system, low, high, tolerance(), state, x); }

    double tolerance() const {
        const dxInteriorPoint::Scale scale = interior.scaleOf(interior.x());
        return 1e-11 * scale.b + 1e-14 * scale.sum;
    }

    RandomBodySpaceProblem random;
    dxPhaseRunner phases;
    dxInteriorPoint interior;
    double residual = 0;
    std::vector<double> low, high, x;
    std::vector<dxRowState> state;
    dxNormalEquations system;
    dxRefinement refinement;
};

TEST(Refinement, FindsForcesOfFreeRows) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        SolvedProblem solved(seed);
        ASSERT_LE(solved.residual, solved.tolerance());
        for (unsigned i = 0; i < solved.random.problem.rowCount; ++i)
            if (solved.state[i] == dxRowState::Free) solved.x[i] = std::clamp(0.0, solved.low[i], solved.high[i]);
        EXPECT_LE(solved.refine(), solved.tolerance()) << seed;
    }
}

TEST(Refinement, SetsARowFreeThatIsNotAtItsLimit) {
    unsigned released = 0;
    for (unsigned seed = 0; seed < 20; ++seed) {
        SolvedProblem solved(seed);
        for (unsigned i = 0; i < solved.random.problem.rowCount; ++i) {
            if (solved.state[i] != dxRowState::Free || !std::isfinite(solved.low[i])) continue;
            solved.state[i] = dxRowState::AtLow;
            solved.x[i] = solved.low[i];
            EXPECT_LE(solved.refine(), solved.tolerance()) << seed;
            EXPECT_EQ(solved.state[i], dxRowState::Free);
            ++released;
            break;
        }
    }
    EXPECT_GT(released, 10u);
}

}  // namespace
