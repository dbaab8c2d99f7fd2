// The island-parallel strategy: islands are stepped side by side by several workers, and what they did is made visible in
// upstream's order (thesis chapter 11). The stages, in this order; WORKERS marks those that are shared:
//
//   dxPrepareIslands         WORKERS  callbacks of the user, rows, feedback; blocks for workers
//   dxReserveRandomNumbers   caller   the block of the step, cut up among the islands
//   dxRemoteStep::make       WORKERS  problems of islands that remote workers solve, if there are any
//   stepBlock                WORKERS  each other island, its messages and moved-notifications put off
//   dxRemoteStep::finish     WORKERS  results of remote workers, in the order in which they come
//   stepRest                 caller   islands for which a worker had no memory
//   commit                   caller   messages and notifications in upstream's order, up to the first island that cannot be
//   finishInOrder            caller   the islands from that one on, as the serial strategy
//
// Upstream's dxProcessIslands lets threads take islands as they come: its random numbers, list orders and messages then
// differ from run to run. docs/exactness.md goes through why the bits stay the same here.
//
// A worker writes only the records of the islands that it steps, and its own worker record (dxStepRecords).
#pragma once

#include <memory>
#include <optional>

#include "dynamics/step/dxDeferredIslands.h"
#include "dynamics/step/dxRemoteSolvers.h"
#include "dynamics/step/dxStepStrategy.h"

class dxIslandParallelStep {
public:
    // The reason of the plan becomes the step's own, if there is one for which a single thread carries it out.
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
