// The problems of one step, from when they are made until each of them has been answered: by a worker, or by this process, because no worker has
// had it yet, because its worker is late, lost or wrong, or because this process is sooner.
//
// Threading: any thread of the step. Waits in next() alone, for workers.
#pragma once

#include <cstdint>
#include <list>
#include <vector>

#include "remote/coordinator/dxRemoteProblem.h"
#include "remote/coordinator/dxRemoteWorkers.h"

class dxRemoteBatch {
public:
    enum class Next { Result, Reclaimed, None };

    // `mayReclaim`: this process takes what no worker has had yet, or what it would solve sooner; otherwise it waits for workers that work. Throws
    // std::bad_alloc.
    dxRemoteBatch(dxRemoteWorkers &workers, unsigned count, bool mayReclaim);
    // A step that ends early forgets the problems that are not back.
    ~dxRemoteBatch();
    dxRemoteBatch(const dxRemoteBatch &) = delete;
    dxRemoteBatch &operator=(const dxRemoteBatch &) = delete;

    // Each of the `count` problems is either submitted, kept (this process has to solve it) or dropped (nobody has to). Nothing from here on
    // takes memory, but messages.
    void submit(unsigned index, dxRemoteBytes &&problem, double cost);
    void keep(unsigned index);
    void drop(unsigned index);

    // This process has solved problems of this step, or islands that were not to go out, whose costs were predicted; the others take as many
    // times theirs.
    void noteLocal(double cost, double ns);

    // Waits until there is something to do. None: all problems have been answered.
    Next next(unsigned &index, dxRemoteBytes &result);

    // The result that next() gave is none: its worker is dropped, and this process solves the problem.
    void reject(unsigned index);
    // It says that the worker could not solve the problem; whoever calls does.
    void noteGivenBack();

    // Memory for a problem that is to be submitted.
    dxRemoteBytes room();

    // Of those that next() has given so far.
    dxRemoteOutcomes outcomes() const;

private:
    using State = dxRemoteProblem::State;

    bool queue(unsigned index, dxRemoteBytes &&problem, double cost);
    void count(dxRemoteOutcome outcome, int change = 1);
    bool takeReady(State state, unsigned &index, dxRemoteBytes *result);
    bool takeUnsent(unsigned &index);
    void reclaimAll();

    dxRemoteWorkers &m_workers;
    dxRemoteScheduler &m_scheduler;
    const bool m_mayReclaim;
    unsigned m_forks = 0;  // when the step began
    dxRemoteProblems m_problems;
    std::list<dxRemoteProblem *> m_nodes;  // of the queue, for problems that are not submitted yet
    unsigned m_left;
    double m_localCost = 0, m_localNs = 0, m_pace = 1;  // ns in this process, of what was predicted so
};
