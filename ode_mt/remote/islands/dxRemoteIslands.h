// The islands of one step that remote workers solve. Each goes through three parts, the first and the last in this process:
//
//   make      gather bodies, order joints, read rows, pack, submit         in blocks
//   solve     by a worker, or by this process after all
//   finish    apply results                                                in the order in which results arrive
//
// The islands' problems are kept until they are finished, in arenas of their own.
//
// Threading: make(), poll(), noteStepped() and finish() on workers of this process; everything else on the thread that called the step.
#pragma once

#include <memory>
#include <vector>

#include "dynamics/step/dxDeferredIslands.h"
#include "dynamics/step/dxRemoteSolvers.h"
#include "dynamics/step/islands/dxIslandStep.h"
#include "dynamics/world_step/dxWorldStepProblem.h"
#include "remote/coordinator/dxRemoteBatch.h"

// Returns what a step asks. Its islands go to dxRemoteWorkers::instance().
dxRemoteSolvers &dxRemoteIslandSolvers();

class dxRemoteIslands final : public dxRemoteStep {
public:
    // Throws std::bad_alloc.
    dxRemoteIslands(dxDeferredIslands &islands, double share, bool isForced);
    ~dxRemoteIslands() override;
    dxRemoteIslands(const dxRemoteIslands &) = delete;
    dxRemoteIslands &operator=(const dxRemoteIslands &) = delete;

    unsigned count() const override { return static_cast<unsigned>(m_entries.size()); }
    void make(unsigned entry, unsigned worker) override;
    void poll() override { dxRemoteWorkers::instance().poll(); }
    void noteStepped(double cost, double ns) override { m_batch->noteLocal(cost * m_scale, ns); }
    void finish(unsigned worker) override;
    dxRemoteRecord finishRest() override;

private:
    struct Entry {
        unsigned island;
        bool isPostponed = false;  // its worker had no memory to solve it
        dxWorldProcessMemArena *arena = nullptr;
        dxWorldStepProblem problem;
    };

    const dxIsland &islandOf(const Entry &entry) const { return m_islands.records().islands[entry.island].island; }
    dxIslandStep stepOf(const Entry &entry, dxWorldProcessMemArena *arena) const;
    double solverCost(const Entry &entry) const;  // ns in this process, predicted

    void makeProblem(unsigned entry);
    bool next(unsigned &entry, dxRemoteBytes &result, bool &hasResult);
    void finishEntry(Entry &entry, unsigned worker, const dxRemoteBytes &result, bool hasResult);
    void apply(Entry &entry, const dxRemoteBytes &result, bool hasResult, dxWorldProcessMemArena *arena);
    void solve(const dxIslandStep &step, Entry &entry);

    dxDeferredIslands &m_islands;
    const double m_scale;
    std::vector<Entry> m_entries;
    std::unique_ptr<dxRemoteBatch> m_batch;
};
