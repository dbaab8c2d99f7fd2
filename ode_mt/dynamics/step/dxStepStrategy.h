// Which way a step goes: the one place that decides it, and learns from how long it took.
//
//   Serial           all islands on the calling thread, in upstream's order (dxSerialStep)
//   IslandParallel   islands side by side on several workers (dxIslandParallelStep)
//   LargeIsland      in order, and an island that outweighs the others by several workers together (dxLargeIslandStep)
//
// Results never depend on the strategy, only speed does. A step stays serial where dxPlanStep says why.
#pragma once

#include <ode/ode.h>

#include "dynamics/step/dxStepCall.h"
#include "settings/dxWorldStatistics.h"

enum class dxStepStrategy { Serial, IslandParallel, LargeIsland };

// Costs (dxCostModel) of the islands before the first one with a moved-callback.
struct dxIslandCosts {
    double total = 0, largest = 0;
    double joints = 0, bodies = 0, islands = 0;
    unsigned maxJoints = 0;
    bool areOfAll = false;  // there is no such callback
};

struct dxStepPlan {
    dxStepStrategy strategy = dxStepStrategy::Serial;
    unsigned workers = 1;  // the caller included
    unsigned minLargeJoints = 0;
    dxIslandCosts costs;
    dODE_MT_Reason reason = dODE_MT_REASON_PARALLEL;  // why it is Serial, or else is carried out by one thread if it is
    double remoteShare = 0;       // of the cost, that remote workers are given; above 0 with IslandParallel only
    bool isRemoteForced = false;  // by an algorithm that is asked for by name
    bool mayBeRemote = false;     // both ways are possible
    dxRemoteRecord remote;        // of what was sent, when the step has been carried out
    bool isMeasured = false;      // its time is worth reading a clock
    bool hasLargeIsland = false;  // both LargeIsland and another strategy are possible
};

// Upstream takes a negative number of iterations for one above two thousand million, and never returns from an island with rows then. It
// may never come to that island, though: one before it, or a world before this one, may report an error.
bool dxMayBeEndless(const dxWorld &world);

dxStepPlan dxPlanStep(const dxStepCall &call);

// Why no more threads took part in a step of this plan than did.
dODE_MT_Reason dxReasonOf(const dxStepCall &call, const dxStepPlan &plan, unsigned threads);

// A step that was measured took `ns`.
void dxLearnFromStep(const dxStepCall &call, const dxStepPlan &plan, double ns);
