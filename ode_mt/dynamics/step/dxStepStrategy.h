// The strategy of a step: decides it, and learns from the time that the step took.
//
//   Serial           all islands on the calling thread, in upstream's order (dxSerialStep)
//   IslandParallel   islands at the same time on several workers (dxIslandParallelStep)
//   LargeIsland      in order, and an island that costs more than the others on several workers together (dxLargeIslandStep)
//
// Results never depend on the strategy, only speed does. dxPlanStep gives the reason for a serial step.
//
// Threading: the thread that calls the step.
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
    dODE_MT_Reason reason = dODE_MT_REASON_PARALLEL;  // why it is Serial, or why one thread does it all the same
    double remoteShare = 0;       // part of the cost that remote workers get; above 0 with IslandParallel only
    bool isRemoteForced = false;  // by an algorithm that the user has named
    bool mayBeRemote = false;     // both ways are possible
    dxRemoteRecord remote;        // of what was sent, after the step
    bool isMeasured = false;      // its time is worth reading a clock
    bool hasLargeIsland = false;  // both LargeIsland and another strategy are possible
};

// Returns whether a step may never end: upstream takes a negative number of iterations for one above two thousand million, and then never returns
// from an island with rows. (It may end all the same, if an island before that one, or a world before this one, reports an error.)
bool dxMayBeEndless(const dxWorld &world);

dxStepPlan dxPlanStep(const dxStepCall &call);

// Returns why no more threads took part in a step of this plan.
dODE_MT_Reason dxReasonOf(const dxStepCall &call, const dxStepPlan &plan, unsigned threads);

// Records that a measured step took `ns`.
void dxLearnFromStep(const dxStepCall &call, const dxStepPlan &plan, double ns);
