// Distributes problems to workers, and reclaims those of workers that are late, lost or wrong. It has the workers, the queue of problems, and the
// problems of all steps in progress.
//
// Rules: the most expensive problems go first, to the worker with the least to do (dxRemoteSchedule.h). Problems of a worker that is late or dropped
// are reclaimed; without a usable worker the whole queue is. A problem is answered exactly once.
//
// Only functions that say so take memory. Units: ns of now().
//
// Threading: under the lock of dxRemoteWorkers, except areThere().
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <list>
#include <unordered_map>
#include <utility>
#include <vector>

#include "remote/coordinator/dxRemoteProblem.h"
#include "remote/coordinator/dxRemoteWorker.h"
#include "remote/transport/dxSpareBytes.h"
#include "threading/pool/dxFutex.h"

// Problems of one message, and their bytes.
struct dxRemoteSending {
    unsigned worker = 0;
    std::uint64_t number = 0;
    std::vector<std::uint64_t> problems;
    std::vector<dxRemoteBytes> bytes;
};

struct dxRemoteCounts {
    std::uint64_t sent = 0;  // problems
    dxRemoteOutcomes outcomes;
    unsigned late = 0, refused = 0, lost = 0, replaced = 0;  // times, workers
    double waitedNs = 0;                                     // by threads of this process, one after the other
    unsigned open = 0, openLate = 0;  // workers now: may get problems; of these, get none for the moment, as they are or were late
};

class dxRemoteScheduler {
public:
    double now() const { return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - m_start).count(); }

    // Returns whether a worker may get problems. Costs one load.
    bool areThere() const { return m_areThere.load(std::memory_order_relaxed); }
    void setNoneThere() { m_areThere.store(false, std::memory_order_relaxed); }
    void noteAvailable() { m_areThere.store(any([](const dxRemoteWorker &one) { return one.isOpen(); }), std::memory_order_relaxed); }

    dxRemoteCapacity capacity() const;
    dxRemoteCounts counts() const;

    std::vector<dxRemoteWorker> &workers() { return m_workers; }
    dxRemoteCounts &counters() { return m_counts; }

    // Notified when a problem is returned or reclaimed. waiting(): the number of threads that wait for that, which they must keep correct.
    dxEventCount &news() { return m_news; }
    unsigned &waiting() { return m_waiting; }

    template <class Condition>
    bool any(Condition isSo) const {
        return std::any_of(m_workers.begin(), m_workers.end(), isSo);
    }
    template <class Condition>
    bool all(Condition isSo) const {
        return std::all_of(m_workers.begin(), m_workers.end(), isSo);
    }

    // --- workers ------------------------------------------------------------------------------------------
    // Called when a transport with these workers is open. The vector is swapped with that of the previous workers.
    void begin(std::vector<dxRemoteWorker> &workers);
    bool hasLost() const { return m_hasLost; }  // a worker, since then

    // Gives the worker no more problems, and reclaims those that it has.
    void dropWorker(unsigned worker, const char *why, const char *detail = "");
    void dropUnreachable(unsigned worker, const char *why);
    void dropAll(const char *why);

    // Reclaims late problems. (While all threads of this process have enough to do, a late result costs nothing, and its time is learnt.)
    void noticeLate();

    // Reports, once, that there is no memory for a message.
    void warnOfMemory();

    // --- problems -----------------------------------------------------------------------------------------
    // Adds the problems of a step, which get their number. Takes memory.
    void add(dxRemoteProblems &problems);
    void remove(const dxRemoteProblems &problems);

    // `nodes`: one of them is taken for the queue.
    void enqueue(dxRemoteProblem &problem, std::list<dxRemoteProblem *> &nodes);

    // Takes the step's cheapest problem that no worker has got; null: there is none.
    dxRemoteProblem *takeUnsent(const dxRemoteProblems &problems);

    // Takes the next message from the queue, if a worker is free. Returns false if there is none. Takes memory; without it the queue is reclaimed,
    // and the message is empty.
    bool takeMessage(dxRemoteSending &sending);
    // Called if the message could not be made.
    void takeMessageBack(const dxRemoteSending &sending);

    // Takes the results of a message. If it is invalid, no result is used, and its worker is dropped. A message without results says that the worker
    // could solve none, or that a withdrawal came in time. Takes memory; without it the problems are reclaimed.
    void accept(unsigned worker, const dxRemoteBytes &results);

    // Returns memory for a problem.
    dxRemoteBytes takeSpare() { return m_spareProblems.take(); }
    void giveSpareBack(dxRemoteBytes &&bytes) { m_spareProblems.giveBack(std::move(bytes)); }

    bool hasQueued() const { return !m_queue.empty(); }
    void forgetQueue() { m_queue.clear(); }

    // Returns whether there are withdrawals that have not been sent.
    bool hasWithdrawals() const { return m_hasWithdrawals; }
    void noteWithdrawalsSent() { m_hasWithdrawals = false; }

    // `why`: for a problem that was sent.
    void reclaim(dxRemoteProblem &problem, dxRemoteOutcome why);
    void reclaimQueue();

    // Reclaims those problems of the step whose results are expected last, if this process would solve them before that. Returns whether it has.
    bool withdrawLast(const dxRemoteProblems &problems);

    // Multiplies the predicted costs of the step's problems.
    void rescale(dxRemoteProblems &problems, double factor);

    // Returns the next time at which a worker will be late.
    double nextDeadline() const;

private:
    void reclaim(const std::vector<std::uint64_t> &problems, dxRemoteOutcome why);
    void store(const dxRemoteBytes &results);
    bool isSolving(const dxRemoteLink &link) const;

    std::vector<dxRemoteWorker> m_workers;
    std::list<dxRemoteProblem *> m_queue;  // the most expensive first
    dxSpareBytes m_spareProblems;
    dxEventCount m_news;
    dxRemoteCounts m_counts;
    unsigned m_waiting = 0;
    bool m_hasWithdrawals = false;
    std::unordered_map<std::uint64_t, dxRemoteProblems *> m_steps;  // by their numbers
    std::uint64_t m_nextMessage = 1, m_nextStep = 1;
    bool m_hasLost = false, m_hasWarnedOfMemory = false;
    std::atomic<bool> m_areThere{false};
    const std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};
