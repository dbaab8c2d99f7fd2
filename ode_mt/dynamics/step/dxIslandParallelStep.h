// The island-parallel strategy: islands are stepped side by side by several workers, and what they did is made visible in
// upstream's order (thesis chapter 11). The stages, in this order; WORKERS marks those that are shared:
//
//   dxPrepareIslands         WORKERS  callbacks of the user, rows, feedback; blocks for workers
//   dxReserveRandomNumbers   caller   the block of the step, cut up among the islands
//   makeRemote               WORKERS  problems of islands that remote workers solve (dxRemoteIslands), if there are any
//   stepBlock                WORKERS  each other island, its messages and moved-notifications put off
//   finishRemote             WORKERS  results of remote workers, in the order in which they come
//   stepRemainingIslands     caller   islands for which a worker had no memory
//   commit                   caller   messages and notifications in upstream's order, up to the first island that cannot be
//   finishInOrder            caller   the islands from that one on, as the serial strategy
//
// Upstream's dxProcessIslands lets threads take islands as they come: its random numbers, list orders and messages then
// differ from run to run. docs/exactness.md goes through why the bits stay the same here.
//
// A worker writes only the records of the islands that it steps, and its own worker record (dxStepRecords).
#pragma once

#include <atomic>
#include <memory>

#include "dynamics/step/dxRemoteIslands.h"
#include "dynamics/step/dxStepRecords.h"
#include "dynamics/step/dxStepStrategy.h"

class dxIslandParallelStep {
public:
    // The reason of the plan becomes the step's own, if there is one for which a single thread carries it out.
    dxIslandParallelStep(const dxStepCall &call, dxStepPlan &plan);

    void run();

private:
    bool prepare();
    void noteOrder();
    void stepBlock(unsigned block, unsigned worker);  // workers
    void runBlocks();
    void stepDeferred(unsigned index, unsigned worker);
    bool hasArena(unsigned worker);
    bool beginIsland(unsigned index, unsigned worker);
    void makeRemote(unsigned entry, unsigned worker);  // workers
    void finishRemote(unsigned worker);                // workers
    void finishRemote(unsigned entry, unsigned worker, const dxRemoteBytes &result, bool hasResult);
    void finishPostponed();
    void interruptAt(unsigned island);
    void stepRemainingIslands();
    unsigned commit();
    void takeBack(unsigned begin);
    void deliverReports(unsigned island) const;
    void giveArenasBack();
    void finishInOrder(unsigned begin);
    void learn(double wallNs) const;
    void learnFromHome(double busyNs) const;

    const dxStepCall &m_call;
    dxStepPlan &m_plan;
    const bool m_userHandlers;  // an error, debug or message handler is installed
    dxStepRecords::Lease m_records;
    std::unique_ptr<dxRemoteIslands> m_remote;  // null: all islands stay at home
    std::atomic<unsigned> m_interrupted;  // first island that has to be stepped again in order
};
