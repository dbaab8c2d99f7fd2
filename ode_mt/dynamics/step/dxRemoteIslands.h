// The islands of one step that remote workers may solve. Each goes through three parts, the first and the last at home:
//
//   make      gather bodies, order joints, read rows, pack, submit         in blocks, by home's threads
//   solve     by a worker, or at home
//   finish    apply results                                                by home's threads, in the order in which results come
//
// The islands' problems are kept until they are finished, in arenas of their own. The scopes in which islands are stepped
// (dxDeferredIsland) and what is saved to undo them are for dxIslandParallelStep.
//
// Threading: make() of different islands and next() on any of home's threads; next() waits for make() of all islands, which must be
// running or done.
#pragma once

#include <memory>
#include <vector>

#include "dynamics/step/dxStepCall.h"
#include "dynamics/step/dxStepRecords.h"
#include "dynamics/step/islands/dxIslandStep.h"
#include "dynamics/world_step/dxWorldStepProblem.h"
#include "remote/dxRemoteWorkers.h"
#include "settings/dxWorldStatistics.h"

class dxRemoteIslands {
public:
    // --- the process -----------------------------------------------------------------------------------------

    // Begins to use the workers that the settings name, if they name any. Once in a process.
    static void open();

    // Ends that.
    static void close();

    // Whether islands of this step may go out at all. Costs one look where there are no workers.
    static bool mayHelp(const dxStepCall &call);

    // dODE_MT_GetRemoteStatistics; the size is the caller's.
    static dODE_MT_RemoteStatistics statistics();

    // For the statistics of a step that went so.
    static dxRemoteRecord recordOf(const dxRemoteOutcomes &outcomes);

    // --- one step --------------------------------------------------------------------------------------------

    // Chooses islands, the most expensive first, until they are `share` of the cost of all; marks their records. `isForced`: home does not take
    // them back from workers that work. Throws std::bad_alloc.
    dxRemoteIslands(const dxStepCall &call, dxStepRecords &records, double share, bool isForced);
    ~dxRemoteIslands();
    dxRemoteIslands(const dxRemoteIslands &) = delete;
    dxRemoteIslands &operator=(const dxRemoteIslands &) = delete;

    unsigned count() const { return static_cast<unsigned>(m_entries.size()); }
    unsigned islandOf(unsigned entry) const { return m_entries[entry].island; }

    // Memory for the problem; false: there is none, and the island has to be stepped as any other one, after drop().
    bool prepare(unsigned entry);
    void make(unsigned entry);
    void drop(unsigned entry) { m_batch->drop(entry); }

    // Islands of this cost, which stay, have been stepped in so long: problems that are away take as many times what was predicted.
    void noteStepped(double cost, double ns) { m_batch->noteHome(cost * m_scale, ns); }

    // Between two islands: messages.
    void help() { dxRemoteWorkers::instance().help(); }

    // Waits for an entry that can be finished; false: there is none left.
    bool next(unsigned &entry, dxRemoteBytes &result, bool &hasResult);
    // Solves it in the arena if there is no result, and applies the results. Reports messages, and so may throw dxUpstreamInterrupted.
    void finish(unsigned entry, const dxRemoteBytes &result, bool hasResult, dxWorldProcessMemArena *arena);

    // Of those that went out, when next() has told of all.
    dxRemoteOutcomes outcomes() const { return m_batch->outcomes(); }

    // For the thread that has no memory to solve: another one finishes it later.
    void postpone(unsigned entry) { m_entries[entry].isPostponed = true; }
    bool isPostponed(unsigned entry) const { return m_entries[entry].isPostponed; }

private:
    struct Entry {
        unsigned island;
        bool isPostponed = false;
        dxWorldProcessMemArena *arena = nullptr;
        dxWorldStepProblem problem;
    };

    dxIslandStep stepOf(const Entry &entry, dxWorldProcessMemArena *arena) const;
    double solverCost(const Entry &entry) const;  // ns at home, predicted
    void solve(const dxIslandStep &step, Entry &entry);

    const dxStepCall &m_call;
    const dxStepRecords &m_records;
    const double m_scale;
    std::vector<Entry> m_entries;
    std::unique_ptr<dxRemoteBatch> m_batch;
};
