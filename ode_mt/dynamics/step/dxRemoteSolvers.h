// Solvers of islands in other processes, as a step sees them: remote/ implements this. Where the user has named no workers, a step reads one pointer
// (installed()).
//
//   dxPlanStep              maySolve(), predictShare(): how much of the step goes to remote workers
//   dxIslandParallelStep    begin(): the islands that do (dxRemoteStep), beside the local ones
//   dxStepIslands           noteWorkers(): for the world's statistics; so does dxStepOnThisThread, of a step of many worlds
//   dxLearnFromStep         wake(): before a step that will use remote workers
//
// Results never depend on it, only speed does.
//
// Threading: any thread that steps a world.
#pragma once

#include <atomic>
#include <memory>

#include "settings/dxWorldStatistics.h"

class dxDeferredIslands;
struct dxStepCall;

// The islands before the first one with a moved-callback.
struct dxRemoteWork {
    double totalNs = 0, largestNs = 0;  // on one thread of this process
    double bodies = 0, joints = 0, islands = 0;
};

// Islands of one step that remote workers solve.
class dxRemoteStep {
public:
    virtual ~dxRemoteStep() = default;

    virtual unsigned count() const = 0;

    // Makes the problem of one of the count() islands and sends it. Called by a worker of this process, once for each, before the local islands.
    virtual void make(unsigned entry, unsigned worker) = 0;

    // Sends and receives messages. Called by a worker of this process between two local islands.
    virtual void poll() = 0;

    // Called by a worker of this process when it has stepped local islands of this cost (dxCostModel, scale 1) in this time.
    virtual void noteStepped(double cost, double ns) = 0;

    // Applies results as they arrive, until there are no more. Called by each worker of this process when nothing else is left. Requires that make()
    // of all islands is running or done.
    virtual void finish(unsigned worker) = 0;

    // Solves islands for which a worker had no memory. Called by the caller of the step when the workers are done. Returns what became of the
    // islands.
    virtual dxRemoteRecord finishRest() = 0;
};

class dxRemoteSolvers {
public:
    // Returns null if the user has named no workers.
    static dxRemoteSolvers *installed() { return s_installed.load(std::memory_order_acquire); }

    // Installs the solvers for the rest of the process.
    static void install(dxRemoteSolvers &solvers) { s_installed.store(&solvers, std::memory_order_release); }

    // Returns whether islands of this step may go to remote workers at all.
    virtual bool maySolve(const dxStepCall &call) const = 0;

    // Returns the part of a step's cost that should go to remote workers; 0: it does not pay.
    virtual double predictShare(const dxRemoteWork &work, unsigned workers) const = 0;

    // Chooses islands, the most expensive first, until they are `share` of the cost of all; marks their records. `isForced`: they are not taken
    // back from workers that work. Throws std::bad_alloc.
    virtual std::unique_ptr<dxRemoteStep> begin(dxDeferredIslands &islands, double share, bool isForced) = 0;

    // Wakes workers that sleep, since islands of the next step will go to them.
    virtual void wake() = 0;

    // Adds what is known of the process's workers now.
    virtual void noteWorkers(dxRemoteRecord &record) const = 0;

protected:
    ~dxRemoteSolvers() = default;

private:
    static inline std::atomic<dxRemoteSolvers *> s_installed{nullptr};
};
