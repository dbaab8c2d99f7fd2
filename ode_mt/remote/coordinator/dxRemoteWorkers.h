// The process's remote workers: links to them, the queue of problems, and the thread that communicates.
//
// A step makes a batch (dxRemoteBatch), submits problems as they are made, and then asks what is next until nothing is left: a result, or a
// problem to be solved at home, because no worker has had it yet, because its worker is late, lost or wrong, or because home is faster.
// A problem is answered once, whatever happens to workers.
//
// Where the transport can, a worker that is lost or has been late for seconds is replaced, one at a time.
//
// The communication thread makes the transport, uses it and closes it; it sleeps while nothing is under way. Where the transport allows it, home's
// threads do in between what that thread would have to be woken for (help()), and it looks less often. A child of fork() has no remote workers;
// neither has a process after close().
//
// Memory: whatever is refused to who communicates, it goes on. Problems that cannot be sent go home; a worker whose message cannot be
// read is left out. What else is thrown there leaves out all workers. The same holds where home's threads communicate; their other calls take no
// memory.
//
// Threading: any thread; one lock, held for moments. Never waits for a worker but in open(). The transport is used without the lock, by whoever has
// the turn (m_isCommunicating).
#pragma once

#include <pthread.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <vector>

#include "remote/transport/dxPollPause.h"
#include "remote/transport/dxRemoteFrame.h"
#include "remote/coordinator/dxRemoteLink.h"
#include "remote/coordinator/dxRemoteOutcomes.h"
#include "remote/transport/dxRemoteTransport.h"
#include "remote/coordinator/dxRestartPause.h"
#include "remote/transport/dxSpareBytes.h"
#include "threading/pool/dxEventCount.h"
#include "threading/process/dxForkListener.h"
#include "threading/process/dxForkLocks.h"
#include "threading/process/dxProcessObject.h"

class dxRemoteBatch;
struct dxRemoteSending;

struct dxRemoteProblem {
    enum class State { Expected, Queued, Sent, Returned, AtHome, Done };

    std::uint64_t number = 0;
    double cost = 0;
    State state = State::Expected;
    unsigned link = 0;
    bool isPatient = false;
    bool isSent = false;
    dxRemoteOutcome outcome = dxRemoteOutcome::Solved;  // of one that was sent and is at home again: why
    dxRemoteBytes bytes;  // the problem, until it is sent; then the result
};

class dxRemoteWorkers final : private dxForkListener {
public:
    static dxRemoteWorkers &instance();

    // Makes a transport on the communication thread; null: `reason` says why not.
    using Open = std::function<std::unique_ptr<dxRemoteTransport>(std::string &reason)>;

    // Waits until the workers have been welcomed or refused, or for two seconds after the transport has been made; there are none if that takes more
    // than `most`. Once in a process, but for tests, which close in between.
    void open(const char *name, const dxRemoteHello &hello, Open open, std::chrono::nanoseconds most = kMostToBegin);

    // Ends the communication thread, and the workers.
    void close();

    // Of threads that the communication thread makes, as MPI does, and its own.
    static constexpr const char *kThreadName = "ode_mt-remote";

    // Before open(): tells whether no threads of the program's are left. It is asked each second; the process ends then as it does with its last
    // thread, with status 0.
    using IsOver = std::function<bool()>;
    void endProcessWhen(IsOver isOver) { m_isOver = std::move(isOver); }

    // Whether there are any, at the cost of one look.
    bool areThere() const { return m_areThere.load(std::memory_order_relaxed); }

    dxRemoteCapacity capacity();

    // Problems are about to come: workers that sleep look for them again as often as they can.
    void wake();

    // Between two islands: sends and receives what there is, if nobody else does, and, unless it is urgent, nobody has for a while.
    void help(bool isUrgent = false);

    struct Counts {
        std::uint64_t sent = 0;  // problems
        dxRemoteOutcomes outcomes;
        unsigned late = 0, refused = 0, lost = 0, replaced = 0;  // times, workers
        double waitedNs = 0;  // by home's threads, one after the other
        unsigned open = 0, openLate = 0;  // workers now: may be given problems; of these, get none for the moment, as they are late or were
    };
    Counts counts();

private:
    friend class dxProcessObject<dxRemoteWorkers>;
    friend class dxRemoteBatch;
    using Lock = std::unique_lock<dxForkSafeMutex>;

    struct Link {
        dxRemoteLink link;
        double echoSent = 0, latencyNs = 0, largeNs = 0;
        unsigned echoes = 0;  // that have come back
        double since = 0;     // when its worker was started
        bool isReplacement = false;
        bool isRefused = false;
        bool isUnreachable = false;  // else one that is lost may live, and has to hear of home: the end of a process may be that of its job
        dxRestartPause restart;
    };

    static constexpr std::chrono::seconds kMostToBegin{100};  // Open MPI itself gives up after 60

    dxRemoteWorkers() { listenToForks(); }
    ~dxRemoteWorkers() = default;
    void inForkedChild() override;

    double now() const;
    void leaveAlone(Lock &lock);

    // --- by whoever has the turn ----------------------------------------------------------------------------
    bool communicateOnce(Lock &lock);
    bool sendNext(Lock &lock);
    bool takeNext(unsigned link, double time, dxRemoteSending &sending);
    void sendHeartbeat(double time, Lock &lock);
    bool sendWithdrawals(Lock &lock);
    bool sendWakeUps(Lock &lock);
    bool hasSomethingToSay() const { return m_isClosing || !m_queue.empty() || m_hasWithdrawals || m_isWaking; }
    bool receiveNext(Lock &lock);
    void handle(unsigned link, const dxRemoteBytes &message, Lock &lock);
    void handleHello(unsigned link, const dxRemoteBytes &message, Lock &lock);
    void handleEcho(unsigned link, const dxRemoteBytes &message, Lock &lock);
    void sendEcho(unsigned link, Lock &lock);
    void handleResults(unsigned link, const dxRemoteBytes &message);
    bool sendTo(unsigned link, const dxRemoteBytes &message, Lock &lock);

    // --- on the communication thread ------------------------------------------------------------------------
    void communicate();
    void begin();
    void awaitTurn(Lock &lock);
    bool replaceLost(Lock &lock);
    bool takeReplacement();
    bool beginReplacement(double time, Lock &lock);
    void sleep(Lock &lock);
    bool isProcessOver(Lock &lock);
    void sendQuit(unsigned link, bool isOrderly, Lock &lock);
    void end();

    // --- on home's threads ----------------------------------------------------------------------------------
    bool help(Lock &lock);
    void tell();
    bool lookForNews(Lock &lock, const dxPollPause &pause);
    void waitForNews(Lock &lock, dxPollPause &pause, double ns);

    // --- under the lock -------------------------------------------------------------------------------------
    void lose(unsigned link, const char *why, const char *detail = "");
    void loseUnreachable(unsigned link, const char *why);
    void loseAll(const char *why);
    void warnOfMemory();
    void takeHome(const std::vector<std::uint64_t> &problems, dxRemoteOutcome why);
    void takeHome(dxRemoteProblem &problem, dxRemoteOutcome why);
    void takeQueueHome();
    bool isSolving(const dxRemoteLink &link) const;
    void noticeLate(double now);
    void noteAvailable();
    bool isSettled() const;

    dxForkSafeMutex m_mutex;
    dxEventCount m_wake;  // of the communication thread
    dxEventCount m_done;  // of threads that wait for results
    dxEventCount m_turn;  // of the communication thread, while one of home's has it
    unsigned m_forks = 0;  // of which this process is the child
    bool m_isCommunicating = false, m_isTurnAwaited = false, m_isAsleep = false;
    std::atomic<bool> m_isForAllThreads{false};  // the transport
    std::atomic<double> m_helpedAt{0};           // when one of home's last looked
    pthread_t m_thread{};
    bool m_isRunning = false, m_isClosing = false, m_hasBegun = false;
    std::atomic<bool> m_areThere{false};

    std::string m_name;
    dxRemoteHello m_hello;
    Open m_open;
    IsOver m_isOver;
    double m_lastLook = 0;  // at that
    std::unique_ptr<dxRemoteTransport> m_transport;
    bool m_canReplace = false, m_isReplacing = false, m_hasLost = false;
    unsigned m_replacedLink = 0;
    dxPollPause m_pause;
    double m_lastAlive = 0;

    std::vector<Link> m_links;
    dxSpareBytes m_spareProblems, m_spareMessages;  // those that home sends
    dxRemoteBytes m_received;
    std::list<dxRemoteProblem *> m_queue;                         // the most expensive first
    std::unordered_map<std::uint64_t, dxRemoteBatch *> m_batches;  // by the upper half of a problem's number
    unsigned m_waiting = 0;  // threads of home's that have nothing else to do
    bool m_hasWithdrawals = false, m_isWaking = false, m_hasWarnedOfMemory = false;
    std::uint64_t m_nextFrame = 1, m_nextBatch = 1;
    Counts m_counts;

    const std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

// The problems of one step. One that ends early forgets those that are not back.
class dxRemoteBatch {
public:
    enum class Next { Result, AtHome, None };

    // `mayHurry`: home takes what no worker has had yet, or what it would solve sooner; otherwise it waits for workers that work. Throws
    // std::bad_alloc.
    dxRemoteBatch(dxRemoteWorkers &workers, unsigned count, bool mayHurry);
    ~dxRemoteBatch();
    dxRemoteBatch(const dxRemoteBatch &) = delete;
    dxRemoteBatch &operator=(const dxRemoteBatch &) = delete;

    // Each of the `count` problems is either submitted, kept (home has to solve it) or dropped (nobody has to). Nothing from here on takes memory.
    void submit(unsigned index, dxRemoteBytes &&problem, double cost);
    void keep(unsigned index);
    void drop(unsigned index);

    // Home has solved problems of this step, or islands that were not to go out, whose costs were predicted; the others take as many times theirs.
    void noteHome(double cost, double ns);

    // Waits until there is something to do. None: all problems have been answered.
    Next next(unsigned &index, dxRemoteBytes &result);

    // The result that next() gave is none: its worker is not trusted any more, and home solves the problem.
    void reject(unsigned index);
    // It says that the worker could not solve the problem; whoever calls does.
    void noteGivenBack();

    // Memory for a problem that is to be submitted.
    dxRemoteBytes room();

    // Of those that next() has given so far.
    dxRemoteOutcomes outcomes() const;

private:
    friend class dxRemoteWorkers;
    using State = dxRemoteProblem::State;

    // Returns whether a worker has nothing to do.
    bool queue(unsigned index, dxRemoteBytes &&problem, double cost);
    void count(dxRemoteOutcome outcome);
    void discount(dxRemoteOutcome outcome);
    bool takeReady(State state, unsigned &index, dxRemoteBytes *result);
    bool takeUnsent(unsigned &index);
    void takeAllHome();
    bool withdrawLast(double now);
    double nextDeadline() const;

    dxRemoteWorkers &m_workers;
    const bool m_mayHurry;
    std::uint64_t m_number = 0;  // the upper half of its problems'
    unsigned m_forks = 0;        // when the step began
    std::vector<dxRemoteProblem> m_problems;
    std::list<dxRemoteProblem *> m_nodes;         // of the queue, for problems that are not submitted yet
    std::vector<unsigned> m_returned, m_atHome;  // with room for all that may come
    unsigned m_left;
    double m_homeCost = 0, m_homeNs = 0, m_pace = 1;  // ns at home, of what was predicted so
    dxRemoteOutcomes m_outcomes;
};
