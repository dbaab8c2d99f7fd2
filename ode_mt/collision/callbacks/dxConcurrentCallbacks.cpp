#include "collision/callbacks/dxConcurrentCallbacks.h"

#include <pthread.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <utility>
#include <vector>

#include "collision/callbacks/dxPairTasks.h"
#include "collision/spaces/dxOrderedSpace.h"
#include "collision/spaces/dxPairDelivery.h"
#include "core/dxPrefetch.h"
#include "core/dxReserve.h"
#include "joints/contact.h"
#include "settings/dxJointAttachment.h"
#include "settings/dxProcessStatistics.h"
#include "settings/dxSettings.h"
#include "settings/dxWorkers.h"
#include "settings/dxWorkersRunner.h"
#include "threading/dxSchedulePoints.h"
#include "threading/dxTaskRunner.h"
#include "threading/pool/dxSpin.h"
#include "threading/process/dxObjectPool.h"
#include "threading/process/dxProcess.h"
#include "threading/timeline/dxTimeline.h"

// Upstream's function: inserts an object at the front of a list of its world.
void addObjectToList(dObject *object, dObject **first);

namespace {

// Memory of a contact joint, for dxJointGroup::alloc, which constructs an object of the type that it is given and marks it as in a
// group.
struct JointMemory {
    explicit JointMemory(dxWorld * /*world*/) {}
    alignas(dxJointContact) unsigned flags = 0;
    std::byte rest[sizeof(dxJointContact) - sizeof(unsigned)];
};
static_assert(sizeof(JointMemory) == sizeof(dxJointContact) && alignof(JointMemory) == alignof(dxJointContact));

// Spins for a mutex that is held for some ten nanoseconds at a time: sleeping takes a thousand times as long.
std::unique_lock<std::mutex> lockBriefly(std::mutex &mutex) {
    std::unique_lock<std::mutex> lock(mutex, std::defer_lock);
    if (!dxSpinUntil([&] { return lock.try_lock(); })) lock.lock();
    return lock;
}

__attribute__((tls_model("initial-exec"))) thread_local dxContactLog *t_current = nullptr;

}  // namespace

dxContactLog *dxContactLog::current() { return t_current; }

dxContactLog::Scope::Scope(dxContactLog &log, unsigned worker) : m_outer(std::exchange(t_current, &log)) { log.m_worker = worker; }
dxContactLog::Scope::~Scope() { t_current = m_outer; }

void dxContactLog::start(std::mutex &groups) {
    m_groups = &groups;
    m_operations.clear();
}

dJointID dxContactLog::create(dWorldID world, dJointGroupID group, const dContact *contact) {
    if (world == nullptr || contact == nullptr) return dxUpstreamJointCreateContact(world, group, contact);
    dxReserveCapacity(m_operations, m_operations.size() + 2);  // two: its attachment takes no memory then
    dxJointContact *const joint = construct(group);
    joint->contact = *contact;
    joint->world = world;
    m_operations.push_back({joint, nullptr, nullptr, true});
    return joint;
}

// Constructs a joint of no world, without the lock.
dxJointContact *dxContactLog::construct(dxJointGroup *group) {
    dxJointContact *joint;
    if (group == nullptr) {
        joint = new dxJointContact(&m_constructionWorld);
    } else {
        joint = new (takeJointMemory(*group)) dxJointContact(&m_constructionWorld);
        joint->flags |= dJOINT_INGROUP;
    }
    m_constructionWorld.firstjoint = nullptr;
    m_constructionWorld.nj = 0;
    joint->world = nullptr;
    return joint;
}

// Several are allocated at once, to avoid coherence misses between tasks.
void *dxContactLog::takeJointMemory(dxJointGroup &group) {
    constexpr int kJointsPerAllocation = 8;
    if (m_freeJointsOf != &group) finish();
    if (m_freeJoints.empty()) {
        m_freeJoints.reserve(kJointsPerAllocation);
        const auto lock = lockBriefly(*m_groups);
        m_freeJointsOf = &group;
        for (int i = 0; i < kJointsPerAllocation; ++i) m_freeJoints.push_back(group.alloc<JointMemory>(nullptr));
    }
    void *const memory = m_freeJoints.back();
    m_freeJoints.pop_back();
    return memory;
}

// Constructs joints of no world in memory that was not used: a group counts its joints, and visits them when it is emptied.
void dxContactLog::finish() {
    while (!m_freeJoints.empty()) construct(m_freeJointsOf);
    m_freeJointsOf = nullptr;
}

// The joint reads as after upstream's dJointAttach.
void dxContactLog::attach(dJointID joint, dBodyID body1, dBodyID body2) {
    m_operations.push_back({joint, body1, body2, false});
    if (joint == nullptr) return;  // upstream reports it at the commit
    const bool isReversed = body1 == nullptr;
    joint->flags = isReversed ? joint->flags | dJOINT_REVERSE : joint->flags & ~dJOINT_REVERSE;
    joint->node[0].body = isReversed ? body2 : body1;
    joint->node[1].body = isReversed ? nullptr : body2;
}

// Joints were written by the task's worker, and bodies by another thread.
void dxContactLog::prefetch(std::size_t index) const {
    constexpr std::size_t kJointPrefetchDistance = 16, kBodyPrefetchDistance = 10;  // operations
    if (index + kJointPrefetchDistance < m_operations.size()) {
        const Operation &operation = m_operations[index + kJointPrefetchDistance];
        const auto begin = reinterpret_cast<const char *>(operation.joint);
        if (operation.isCreation)
            dxPrefetch::linesForWrite(begin, static_cast<std::size_t>(reinterpret_cast<const char *>(operation.joint->node + 2) - begin));
    }
    if (index + kBodyPrefetchDistance >= m_operations.size()) return;
    const Operation &operation = m_operations[index + kBodyPrefetchDistance];
    if (operation.body1 != nullptr) dxPrefetch::lineForWrite(&operation.body1->firstjoint);
    if (operation.body2 != nullptr) dxPrefetch::lineForWrite(&operation.body2->firstjoint);
}

void dxContactLog::commit(Span span) {
    for (std::uint32_t i = span.begin; i != span.end; ++i) {
        prefetch(i);
        const Operation &operation = m_operations[i];
        dxJoint *const joint = operation.joint;
        if (operation.isCreation) {
            addObjectToList(joint, reinterpret_cast<dObject **>(&joint->world->firstjoint));
            ++joint->world->nj;
            joint->node[0].body = joint->node[1].body = nullptr;
        } else {
            dxJointAttachment::attach(joint, operation.body1, operation.body2);
        }
    }
}

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

// The state of a call; objects are reused from call to call.
struct Run {
    dxPairTasks pairTasks;
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
    pairTasks.cut(*pairs, space.broadphase(), workers * kTasksPerWorker, dxSettings::instance().callbackPolicy() == dxCallbackPolicy::Independent);
    while (logs.size() < pairTasks.tasks().size()) logs.push_back(std::make_unique<dxContactLog>());
    for (std::size_t i = 0; i < pairTasks.tasks().size(); ++i) logs[i]->start(groups);
    spans.assign(pairs->size(), {});
    taskOfPair.assign(pairs->size(), 0);
}

void Run::runTask(unsigned task, unsigned worker) {
    dxContactLog &log = *logs[task];
    const dxContactLog::Scope scope(log, worker);
    const dxPairTasks::Task &range = pairTasks.tasks()[task];
    for (std::uint32_t i = range.begin; i != range.end; ++i) {
        const std::uint32_t pair = pairTasks.order()[i];
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
        if (exception == nullptr) {  // no exception of C++: the thread is ending (pthread_exit), which must not be stopped
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

// Ends the thread that called dSpaceCollide, because a callback has ended the worker that it ran on: without workers it would have ended this
// thread. The pool is recreated with as many workers as before.
[[noreturn]] void endThread() {
    dxWorkers::instance().stop();
    pthread_exit(nullptr);
}

dxProcessObject<dxObjectPool<Run>> idleRuns;

// Under a clustered algorithm its heuristics may lower the number.
unsigned workersFor(dxOrderedSpace &space, const dxTaskRunner &runner) {
    const bool mayCluster = dxSettings::instance().algorithm() != dxAlgorithm::Auto && space.broadphase() != nullptr;
    return mayCluster ? space.broadphase()->threads(runner.workers()) : runner.workers();
}

// Returns whether, under `auto`, more than half of the pairs are in one task, as in a heap. One worker would run their callbacks while the
// others wait; with the narrow-phase prefetch all have work.
bool isUnbalanced(const dxPairTasks &pairTasks, std::size_t pairs) {
    if (dxSettings::instance().algorithm() != dxAlgorithm::Auto) return false;
    return std::any_of(pairTasks.tasks().begin(), pairTasks.tasks().end(), [pairs](const dxPairTasks::Task &task) {
        return 2 * std::size_t{task.end - task.begin} > pairs;
    });
}

// Cuts the pairs into tasks. Returns false if the callbacks should not run concurrently, or without memory.
bool start(std::optional<dxPooledObject<Run>> &lease, const dxOrderedSpace &space, unsigned workers) {
    try {
        (*lease.emplace(*idleRuns)).start(space, workers);
    } catch (const std::bad_alloc &) {
        return false;
    }
    return (*lease)->pairTasks.tasks().size() >= 2 && !isUnbalanced((*lease)->pairTasks, space.pairs().size());
}

// Requires a locked space.
bool collideLocked(dxOrderedSpace &space, dxTaskRunner &runner, void *data, dNearCallback *callback) {
    if (space.findPairsOnWorkers(runner) != dxPairsFound::Kept) return false;
    const unsigned workers = workersFor(space, runner);
    if (workers < 2 || space.pairs().size() < kMinPairs) return false;
    std::optional<dxPooledObject<Run>> lease;
    if (!start(lease, space, workers)) return false;
    Run &run = **lease;
    const auto tasks = static_cast<unsigned>(run.pairTasks.tasks().size());
    run.data = data;
    run.callback = callback;
    dxWorkersRunner workersRunner(workers);
    {
        const Commit commit{run};
        workersRunner.forBlocks(dxParallelStage::Callbacks, tasks, [&run](unsigned task, unsigned worker) { run.runTask(task, worker); });
    }
    dxProcessStatistics::instance().countParallelCollision(workersRunner.tookPart());
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
