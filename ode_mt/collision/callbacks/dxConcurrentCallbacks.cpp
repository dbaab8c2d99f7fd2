#include "collision/callbacks/dxConcurrentCallbacks.h"

#include <pthread.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <vector>

#include "collision/callbacks/dxContactLog.h"
#include "collision/callbacks/dxPairTasks.h"
#include "collision/spaces/dxOrderedSpace.h"
#include "collision/spaces/dxPairDelivery.h"
#include "settings/dxSettings.h"
#include "settings/dxStepStatistics.h"
#include "settings/dxWorkers.h"
#include "settings/dxWorkersRunner.h"
#include "threading/dxSchedulePoints.h"
#include "threading/dxTaskRunner.h"
#include "threading/process/dxObjectPool.h"
#include "threading/process/dxProcess.h"
#include "threading/timeline/dxTimelineSpan.h"

namespace {

// More tasks than workers compensate for the unknown cost of a pair.
constexpr unsigned kTasksPerWorker = 8;

constexpr std::size_t kMinPairs = 2;

constexpr dxTimelineEvent kCommitContacts{"commit contacts", "collision", {"pairs"}};

// Records the range of a pair's operations in a log, also for a callback that ends its thread.
class Recording {
public:
    Recording(const dxContactLog &log, dxContactLog::Span &span) : m_log(log), m_span(span) {
        m_span.begin = log.position();
    }
    ~Recording() { m_span.end = m_log.position(); }
    Recording(const Recording &) = delete;
    Recording &operator=(const Recording &) = delete;

private:
    const dxContactLog &m_log;
    dxContactLog::Span &m_span;
};

// What a call needs, kept from call to call.
struct Run {
    dxPairTasks cut;
    std::vector<std::unique_ptr<dxContactLog>> logs;  // by task
    std::vector<dxContactLog::Span> spans;            // by pair
    std::vector<std::uint32_t> taskOfPair;
    std::mutex groups;
    std::mutex failure;
    std::atomic<bool> failed{false};       // no further callback
    std::atomic<bool> threadEnded{false};  // by a callback, with pthread_exit
    std::exception_ptr thrown;

    const std::vector<dxOrderedPair> *pairs = nullptr;
    void *data = nullptr;
    dNearCallback *callback = nullptr;

    void start(const dxOrderedSpace &space, unsigned workers);
    void runTask(unsigned task, unsigned worker);
    void deliver(const dxOrderedPair &pair);
    void commit();
};

void Run::start(const dxOrderedSpace &space, unsigned workers) {
    pairs = &space.pairs();
    failed.store(false, std::memory_order_relaxed);
    threadEnded.store(false, std::memory_order_relaxed);
    thrown = nullptr;
    cut.cut(*pairs, space.broadphase(), workers * kTasksPerWorker,
            dxSettings::instance().callbackPolicy() == dxCallbackPolicy::Independent);
    while (logs.size() < cut.tasks().size()) logs.push_back(std::make_unique<dxContactLog>());
    for (std::size_t i = 0; i < cut.tasks().size(); ++i) logs[i]->start(groups);
    spans.assign(pairs->size(), {});
    taskOfPair.assign(pairs->size(), 0);
}

void Run::runTask(unsigned task, unsigned worker) {
    dxContactLog &log = *logs[task];
    const dxContactLog::Scope scope(log, worker);
    const dxPairTasks::Task &range = cut.tasks()[task];
    for (std::uint32_t i = range.begin; i != range.end; ++i) {
        const std::uint32_t pair = cut.order()[i];
        taskOfPair[pair] = task;
        dxPerturb(dxSchedulePoint::DeliverPair);
        if (failed.load(std::memory_order_relaxed)) continue;
        const Recording recording(log, spans[pair]);
        deliver((*pairs)[pair]);
    }
}

void Run::deliver(const dxOrderedPair &pair) {
    if (!dxGeomIsEnabled(pair.first) || !dxGeomIsEnabled(pair.second)) return;
    try {
        dxDeliver(pair, data, callback);
    } catch (...) {
        const std::exception_ptr exception = std::current_exception();
        if (exception == nullptr) {  // none of C++'s, but the end of a thread, which may not be held up
            threadEnded.store(true);
            failed.store(true);
            throw;
        }
        const std::lock_guard<std::mutex> lock(failure);
        if (!failed.exchange(true)) thrown = exception;
    }
}

void Run::commit() {
    dxTimelineSpan span(kCommitContacts);
    span.set(0, pairs->size());
    if (span.ring() != nullptr) span.ring()->pairs += pairs->size();
    dxPerturb(dxSchedulePoint::CommitContacts);
    for (std::uint32_t pair = 0; pair < pairs->size(); ++pair) logs[taskOfPair[pair]]->commit(spans[pair]);
    for (const std::unique_ptr<dxContactLog> &log : logs) log->finish();
}

// Puts the joints into their lists even if the thread ends in a callback.
struct Commit {
    Run &run;
    ~Commit() { run.commit(); }
};

// A callback has ended the worker that it ran on. As an exception, that is passed on: without workers it would have
// ended the thread that called dSpaceCollide. The pool is recreated, with as many workers as before.
[[noreturn]] void endThread() {
    dxWorkers::instance().stop();
    pthread_exit(nullptr);
}

dxProcessObject<dxObjectPool<Run>> idleRuns;

// Of an algorithm that clusters: as many as its heuristics want.
unsigned workersFor(dxOrderedSpace &space, const dxTaskRunner &runner) {
    const bool mayCluster = dxSettings::instance().algorithm() != dxAlgorithm::Auto && space.broadphase() != nullptr;
    return mayCluster ? space.broadphase()->threads(runner.workers()) : runner.workers();
}

// Under auto: more than half of the pairs are in one task, as in a heap. One worker would run their callbacks while the
// others wait; with the narrow-phase prefetch all have work.
bool isLopsided(const dxPairTasks &cut, std::size_t pairs) {
    if (dxSettings::instance().algorithm() != dxAlgorithm::Auto) return false;
    return std::any_of(cut.tasks().begin(), cut.tasks().end(), [pairs](const dxPairTasks::Task &task) {
        return 2 * std::size_t{task.end - task.begin} > pairs;
    });
}

// Cuts the pairs into tasks. Returns false if the callbacks should not run concurrently, or there is no memory for
// that.
bool start(std::optional<dxPooledObject<Run>> &lease, const dxOrderedSpace &space, unsigned workers) {
    try {
        (*lease.emplace(*idleRuns)).start(space, workers);
    } catch (const std::bad_alloc &) {
        return false;
    }
    return (*lease)->cut.tasks().size() >= 2 && !isLopsided((*lease)->cut, space.pairs().size());
}

// The part between locking the space and unlocking it.
bool collideLocked(dxOrderedSpace &space, dxTaskRunner &runner, void *data, dNearCallback *callback) {
    if (space.findPairsOnWorkers(runner) != dxPairsFound::Kept) return false;
    const unsigned workers = workersFor(space, runner);
    if (workers < 2 || space.pairs().size() < kMinPairs) return false;
    std::optional<dxPooledObject<Run>> lease;
    if (!start(lease, space, workers)) return false;
    Run &run = **lease;
    const auto tasks = static_cast<unsigned>(run.cut.tasks().size());
    run.data = data;
    run.callback = callback;
    dxWorkersRunner workersRunner(workers);
    {
        const Commit commit{run};
        workersRunner.forBlocks(dxParallelStage::Callbacks, tasks, [&run](unsigned task, unsigned worker) { run.runTask(task, worker); });
    }
    dxStepStatistics::instance().countParallelCollision(workersRunner.tookPart());
    if (run.threadEnded.load()) endThread();
    if (run.thrown != nullptr) std::rethrow_exception(run.thrown);
    return true;
}

}  // namespace

bool dxCollideConcurrently(dxOrderedSpace &space, dxTaskRunner &runner, void *data, dNearCallback *callback) {
    space.lock_count++;
    const bool done = collideLocked(space, runner, data, callback);
    space.lock_count--;  // not if an exception passes, as upstream
    return done;
}
