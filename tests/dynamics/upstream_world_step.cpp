#include "upstream_world_step.h"

// All that upstream's file includes, so that its guards leave nothing for the namespace.
#include <ode/odeconfig.h>
#include <ode/rotation.h>
#include <ode/timer.h>
#include <ode/error.h>
#include "config.h"
#include "odemath.h"
#include "matrix.h"
#include "objects.h"
#include "joints/joint.h"
#include "lcp.h"
#include "util.h"
#include "threadingutils.h"

#include <cmath>
#include <cstring>
#include <new>

namespace {

RecordedProblem *recorded = nullptr;

void solveRecorded(dxWorldProcessMemArena *arena, unsigned n, dReal *A, dReal *pairsBX, dReal *w, unsigned bilateral,
                   dReal *pairsLoHi, int *findex) {
    recorded->recordProblem(n, A, pairsBX, bilateral, pairsLoHi, findex);
    dxSolveLCP(arena, n, A, pairsBX, w, bilateral, pairsLoHi, findex);
    recorded->recordSolution(pairsBX);
}

std::uint64_t bitsOf(dReal number) {
    std::uint64_t bits = 0;
    if (std::isnan(number)) return ~bits;
    std::memcpy(&bits, &number, sizeof number);
    return bits;
}

}  // namespace

void RecordedProblem::recordProblem(unsigned n, const dReal *A, const dReal *pairsBX, unsigned bilateralJoints,
                                    const dReal *pairsLoHi, const int *findex) {
    rows = n;
    bilateral = bilateralJoints;
    for (unsigned i = 0; i < n; ++i) {
        for (unsigned j = 0; j <= i; ++j) matrix.push_back(bitsOf(A[std::size_t(i) * dPAD(n) + j]));
        rightSide.push_back(bitsOf(pairsBX[std::size_t(i) * PBX__MAX + PBX_B]));
        limits.push_back(bitsOf(pairsLoHi[std::size_t(i) * PLH__MAX + PLH_LO]));
        limits.push_back(bitsOf(pairsLoHi[std::size_t(i) * PLH__MAX + PLH_HI]));
        normalOf.push_back(findex[i]);
    }
}

void RecordedProblem::recordSolution(const dReal *pairsBX) {
    for (unsigned i = 0; i < rows; ++i) solution.push_back(bitsOf(pairsBX[std::size_t(i) * PBX__MAX + PBX_X]));
}

namespace upstream {
#define dxSolveLCP solveRecorded
#include "step.cpp"
#undef dxSolveLCP
}  // namespace upstream

void stepIslandAsUpstream(const dxStepperProcessingCallContext &island, RecordedProblem &problem) {
    recorded = &problem;
    upstream::dxStepIsland(&island);
}
