// Solvers of islands in other processes, as a step sees them: remote/ implements this. A step of a program whose user named no workers looks at one
// pointer (installed()).
//
//   dxPlanStep              maySolve(), predictShare(): how much of the step goes out
//   dxIslandParallelStep    begin(): the islands that do (dxRemoteStep), beside those that stay
//   dxStepIslands           noteWorkers(): for the world's statistics; so does dxStepOnThisThread, of a step of many worlds
//   dxLearnFromStep         wake(): before a step that will go out
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

    // On a worker of this process, once for each of the `count` islands, before those that stay: makes its problem and sends it.
    virtual void make(unsigned entry, unsigned worker) = 0;

    // On a worker of this process, between two islands that stay: messages.
    virtual void poll() = 0;

    // On a worker of this process: islands that stay, of this cost (dxCostModel, scale 1), have been stepped in so long.
    virtual void noteStepped(double cost, double ns) = 0;

    // On each worker of this process, when nothing else is left: applies results as they come, until there are no more. make() of all islands must be
    // running or done.
    virtual void finish(unsigned worker) = 0;

    // On the caller, when the workers are done: islands for which a worker had no memory. Returns what became of those that went out.
    virtual dxRemoteRecord finishRest() = 0;
};

class dxRemoteSolvers {
public:
    // Null: the user has named no workers.
    static dxRemoteSolvers *installed() { return s_installed.load(std::memory_order_acquire); }

    // For the rest of the process.
    static void install(dxRemoteSolvers &solvers);

    // Whether islands of this step may go out at all.
    virtual bool maySolve(const dxStepCall &call) const = 0;

    // The part of a step's cost that should go out; 0: it does not pay.
    virtual double predictShare(const dxRemoteWork &work, unsigned workers) const = 0;

    // Chooses islands, the most expensive first, until they are `share` of the cost of all; marks their records. `isForced`: they are not taken
    // back from workers that work. Throws std::bad_alloc.
    virtual std::unique_ptr<dxRemoteStep> begin(dxDeferredIslands &islands, double share, bool isForced) = 0;

    // Islands of the next step go out: workers that sleep should be awake by then.
    virtual void wake() = 0;

    // Adds what is known of the process's workers now.
    virtual void noteWorkers(dxRemoteRecord &record) const = 0;

protected:
    ~dxRemoteSolvers() = default;

private:
    static std::atomic<dxRemoteSolvers *> s_installed;
};
