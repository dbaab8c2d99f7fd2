// Dantzig's algorithm gives the bits of upstream's LCP solver, for every instruction set of this machine.
//
// Covers dxLargeIslandStep.cpp.
#include <gtest/gtest.h>

#include <ode/error.h>
#include <ode/odemath.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "config.h"

#include "lcp.h"
#include "util.h"

#include "dynamics/step/dxLargeIslandStep.h"
#include "dynamics/world_step/exact/dxDantzig.h"
#include "../threading/manager_runner.h"
#include "instruction_sets.h"
#include "kept_messages.h"
#include "lcp_problem.h"

namespace {

using Solver = decltype(&dxSolveLCP);

void solveAlone(dxWorldProcessMemArena *memory, unsigned n, dReal *A, dReal *pairsBX, dReal *w, unsigned bilateral,
                dReal *pairsLoHi, int *normalOf) {
    dxSolveDantzig(nullptr, memory, n, A, pairsBX, w, bilateral, pairsLoHi, normalOf);
}

// Everything that is worth sharing for a test is shared.
ManagerRunner &workers() {
    static ManagerRunner runner(3);
    return runner;
}

void solveShared(dxWorldProcessMemArena *memory, unsigned n, dReal *A, dReal *pairsBX, dReal *w, unsigned bilateral,
                 dReal *pairsLoHi, int *normalOf) {
    const dxLargeIslandWorkersLease islandWorkers(workers(), true);
    dxSolveDantzig(&*islandWorkers, memory, n, A, pairsBX, w, bilateral, pairsLoHi, normalOf);
}

struct Solution {
    std::vector<dReal> x;
    std::string messages;
    int flags;
};

// The floating-point state that the program may have left.
int raisedBefore = 0, rounding = FE_TONEAREST;

Solution solve(Solver solver, Problem problem, bool friction) {
    dxWorldProcessMemArena *arena = dxAllocateTemporaryWorldProcessMemArena(
        dxEstimateSolveLCPMemoryReq(problem.n, false), nullptr, nullptr);
    arena->ResetState();
    keptMessages.clear();
    dSetMessageHandler(keepMessage);
    dSetDebugHandler(keepMessageAndLeave);
    std::feclearexcept(FE_ALL_EXCEPT);
    std::feraiseexcept(raisedBefore);
    std::fesetround(rounding);
    try {
        solver(arena, problem.n, problem.A.data(), problem.bx.data(), nullptr, problem.bilateral,
               problem.limits.data(), friction ? problem.normalOf.data() : nullptr);
    } catch (const std::runtime_error &) {
        std::fill(problem.bx.begin(), problem.bx.end(), dReal(0));
    }
    std::fesetround(FE_TONEAREST);
    Solution solution{{}, keptMessages, std::fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW)};
    dSetMessageHandler(nullptr);
    dSetDebugHandler(nullptr);
    dxFreeTemporaryWorldProcessMemArena(arena);
    for (unsigned i = 0; i < problem.n; ++i) solution.x.push_back(problem.bx[2 * i + 1]);
    return solution;
}

void expectSame(const Problem &problem, bool friction, const std::string &what) {
    const Solution upstream = solve(dxSolveLCP, problem, friction);
    for (const Solver solver : {solveAlone, solveShared}) {
        const Solution ours = solve(solver, problem, friction);
        EXPECT_EQ(std::memcmp(upstream.x.data(), ours.x.data(), problem.n * sizeof(dReal)), 0) << what;
        EXPECT_EQ(upstream.messages, ours.messages) << what;
        EXPECT_EQ(upstream.flags, ours.flags) << what;
    }
}

}  // namespace

TEST(Dantzig, HasUpstreamsSolution) {
    const Shape shapes[] = {
        {1, 0, 4, 1e-5, 0, false, false},    {5, 2, 12, 1e-5, 0, true, true},
        {12, 0, 30, 1e-5, 0, true, false},   {24, 6, 40, 1e-5, 1, true, true},
        {33, 32, 60, 1e-5, 0, false, false}, {40, 0, 80, 1e-5, 1, true, false},
        {64, 17, 90, 1e-5, 2, true, true},   {90, 60, 130, 1e-5, 0, true, false},
        {130, 0, 200, 1e-5, 1, true, true},  {200, 40, 260, 1e-6, 1, true, true},
        {60, 60, 80, 1e-5, 0, false, false, 6}, {90, 50, 120, 1e-5, 1, true, false, 9},
        {90, 0, 120, 1e-5, 1, true, true, 12},  {300, 200, 400, 1e-5, 0, true, true, 10},
        {300, 0, 250, 1e-6, 1, true, true, 30}, {250, 10, 200, 1e-4, 0, true, false, 20},
        {400, 0, 500, 1e-5, 1, true, true, 9},  {290, 50, 290, 1e-5, 0, true, false, 6},
        {330, 0, 400, 1e-5, 0, true, true},     {420, 150, 450, 1e-5, 1, true, true, 80},
    };
    const unsigned before = workers().blocksOfOthers();
    for (const std::int64_t set : instructionSets()) {
        onInstructionSet(set, [&] {
            for (const Shape &shape : shapes) {
                for (unsigned seed = 0; seed < (shape.n < 100 ? 40 : 6); ++seed) {
                    const std::string what = std::to_string(shape.n) + " rows, seed " + std::to_string(seed);
                    expectSame(Problem(shape, seed), seed % 3 != 0, what);
                }
            }
        });
    }
    EXPECT_GT(workers().blocksOfOthers(), before + 1000);
}

// Models bodies with more constraints than degrees of freedom: A is singular.
TEST(Dantzig, HasUpstreamsSolutionOfSingularProblems) {
    unsigned gaveUp = 0;
    for (const double softness : {0.0, 1e-14, 1e-10}) {
        for (const unsigned n : {6u, 20u, 50u, 90u}) {
            for (unsigned seed = 0; seed < 40; ++seed) {
                const Problem problem({n, 0, n / 2 + 1, softness, 1, true, false}, seed);
                expectSame(problem, true, std::to_string(n) + " rows, seed " + std::to_string(seed));
                gaveUp += !solve(solveAlone, problem, true).messages.empty();
            }
        }
    }
    EXPECT_GT(gaveUp, 5u);
}

// Results that are no numbers, and exceptions that the user has asked for.
TEST(Dantzig, HasUpstreamsSolutionBeyondTheRangeOfNumbers) {
    const double most = std::numeric_limits<dReal>::max_exponent10;
    for (unsigned seed = 0; seed < 200; ++seed)
        expectSame(Problem({30, 4, 60, 1e-5, most / 6 * (1 + seed % 4), true, false}, seed), true,
                   "seed " + std::to_string(seed));
}

// Halves without a force keep zeros, whose signs depend on what was added up.
TEST(Dantzig, HasUpstreamsSolutionWithAnyRoundingAndWhateverWasRaisedBefore) {
    for (const int mode : {FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO, FE_TONEAREST}) {
        rounding = mode;
        for (const int raised : {0, FE_OVERFLOW, FE_INVALID | FE_DIVBYZERO}) {
            raisedBefore = raised;
            for (unsigned seed = 0; seed < 20; ++seed) {
                Problem problem({96, seed % 2 ? 20u : 80u, 120, 1e-5, 1, true, true, 10}, seed);
                if (seed % 4 > 1) problem.separateHalves();
                for (unsigned i = 48; i < 96 && seed % 4 > 1; ++i) problem.bx[2 * i] = 0;
                expectSame(problem, true, "seed " + std::to_string(seed));
            }
        }
    }
    rounding = FE_TONEAREST;
    raisedBefore = 0;
}

// Zeros hide what they are multiplied with.
TEST(Dantzig, HasUpstreamsSolutionOfWhatIsNoNumber) {
    using Limits = std::numeric_limits<dReal>;
    for (const dReal value : {Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN()}) {
        for (unsigned seed = 0; seed < 30; ++seed) {
            Problem problem({96, 40 * (seed % 3), 120, 1e-5, 1, true, true, 10}, seed);
            problem.separateHalves();
            if (seed % 4 < 2) problem.removeLimits();  // the forces are not compared
            (seed % 2 ? problem.bx[2 * seed] : problem.A[problem.skip * 30 + seed]) = value;
            for (const int raised : {0, FE_OVERFLOW | FE_INVALID | FE_DIVBYZERO}) {
                raisedBefore = raised;
                expectSame(problem, true, "seed " + std::to_string(seed));
            }
        }
    }
    raisedBefore = 0;
}

TEST(Dantzig, LeavesLimitsThatCannotBeToUpstreamsAsserts) {
    Problem problem({20, 3, 40, 1e-5, 0, true, false}, 1);
    problem.limits[2 * 7] = 1;  // low
    EXPECT_NE(solve(solveAlone, problem, true).messages.find("dxSolveLCP_Generic"), std::string::npos);
    expectSame(problem, true, "a low limit above 0");
}
