// The island-parallel strategy: several workers step islands at the same time, and the results become visible in
// upstream's order (thesis chapter 11). The stages, in this order; WORKERS marks the parallel ones:
//
//   dxPrepareIslands         WORKERS  callbacks of the user, rows, feedback; blocks for workers
//   dxReserveRandomNumbers   caller   the random numbers of the step, as one block that is divided among the islands
//   dxRemoteStep::make       WORKERS  problems of islands that remote workers solve, if there are any
//   stepBlock                WORKERS  each other island, with its messages and moved-notifications deferred
//   dxRemoteStep::finish     WORKERS  results of remote workers, in the order in which they arrive
//   stepRest                 caller   islands for which a worker had no memory
//   commit                   caller   messages and notifications in upstream's order, up to the first island for which that is not possible
//   finishInOrder            caller   the islands from that one on, as in the serial strategy
//
// Upstream's dxProcessIslands lets threads take islands in any order: its random numbers, list orders and messages then
// differ from run to run. docs/exactness.md explains why the bits are the same here.
//
// Threading: a worker writes only the records of the islands that it steps, and its own worker record (dxStepRecords).
#pragma once

#include <memory>
#include <optional>

#include "dynamics/step/dxDeferredIslands.h"
#include "dynamics/step/dxRemoteSolvers.h"
#include "dynamics/step/dxStepStrategy.h"

class dxIslandParallelStep {
public:
    // Sets the plan's reason if a single thread steps the islands all the same.
    dxIslandParallelStep(const dxStepCall &call, dxStepPlan &plan) : m_call(call), m_plan(plan) {}

    void run();

private:
    bool prepare();
    void noteOrder();
    void runBlocks();
    void stepBlock(unsigned block, unsigned worker);  // workers
    void finishInOrder(unsigned begin);
    void learn(double wallNs) const;
    void learnFromRest(double busyNs) const;

    const dxStepCall &m_call;
    dxStepPlan &m_plan;
    dxStepRecords::Lease m_records;
    std::optional<dxDeferredIslands> m_islands;
    std::unique_ptr<dxRemoteStep> m_remote;  // null: no island goes out
};
