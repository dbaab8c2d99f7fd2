// Upstream's exact step of an island, compiled from its own source, with the problem that it hands to its LCP solver.
#pragma once

#include <ode/common.h>

#include <cstdint>
#include <vector>

struct dxStepperProcessingCallContext;

// What an island's rows come to. All NaNs have the same bits.
struct RecordedProblem {
    unsigned rows = 0, bilateral = 0;
    std::vector<std::uint64_t> matrix;  // lower triangle
    std::vector<std::uint64_t> rightSide, limits, solution;
    std::vector<int> normalOf;

    void recordProblem(unsigned n, const dReal *A, const dReal *pairsBX, unsigned bilateralJoints, const dReal *pairsLoHi,
                       const int *findex);
    void recordSolution(const dReal *pairsBX);
};

// Left as it is where there are no rows.
void stepIslandAsUpstream(const dxStepperProcessingCallContext &island, RecordedProblem &problem);
