// The problems of one step, from when they are made until each has been answered: by a worker, or by this process, because no worker has
// got it yet, because its worker is late, lost or wrong, or because this process is faster.
//
// Threading: any thread of the step. Only next() waits for workers.
#pragma once

#include <cstdint>
#include <list>
#include <vector>

#include "remote/coordinator/dxRemoteProblem.h"
#include "remote/coordinator/dxRemoteWorkers.h"

class dxRemoteBatch {
public:
    enum class Next { Result, Reclaimed, None };

    // `mayReclaim`: this process takes problems that no worker has got yet, or that it would solve sooner; otherwise it waits as long as workers
    // answer. Throws std::bad_alloc.
    dxRemoteBatch(dxRemoteWorkers &workers, unsigned count, bool mayReclaim);
    // If the step ends early, problems without a result are forgotten.
    ~dxRemoteBatch();
    dxRemoteBatch(const dxRemoteBatch &) = delete;
    dxRemoteBatch &operator=(const dxRemoteBatch &) = delete;

    // Each of the `count` problems is either submitted, kept (this process has to solve it) or dropped (it need not be solved). From here on only
    // messages take memory.
    void submit(unsigned index, dxRemoteBytes &&problem, double cost);
    void keep(unsigned index);
    void drop(unsigned index);

    // Called when this process has solved problems of this step, or local islands, in `ns`. The ratio to their predicted cost is assumed for the
    // other problems, too.
    void noteLocal(double cost, double ns);

    // Waits for a problem that can be finished or has to be solved here. Returns None when all problems have been answered.
    Next next(unsigned &index, dxRemoteBytes &result);

    // Called if the result that next() gave is invalid: its worker is dropped, and this process solves the problem.
    void reject(unsigned index);
    // Called if the result says that the worker could not solve the problem; the caller solves it.
    void noteGivenBack();

    // Returns memory for a problem that will be submitted.
    dxRemoteBytes takeSpare();

    // Returns the outcomes of those that next() has given so far.
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
    double m_localCost = 0, m_localNs = 0, m_costRatio = 1;  // predicted and measured in this process (ns), and their ratio
};
