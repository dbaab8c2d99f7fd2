#include "threading/managers/dxThreadManagerPthread.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <new>

#include "core/dxGuards.h"
#include "core/dxLog.h"
#include "threading/pool/dxSpin.h"
#include "threading/process/dxProcessThreads.h"
#include "threading/timeline/dxTimeline.h"

namespace {

constexpr dxTimelineEvent kSpins{"spins", "idle", {}, dxTimelineEvent::Kind::Idle};
constexpr dxTimelineEvent kSleeps{"sleeps", "idle", {}, dxTimelineEvent::Kind::Idle};

}  // namespace

dxThreadManagerPthread::dxThreadManagerPthread(dxCreateThread create, const dxWorkerOptions &options)
    : m_create(create), m_options(options) {
    listenToForks();
}

dxThreadManagerPthread::~dxThreadManagerPthread() {
    ignoreForks();
    stop();
}

void dxThreadManagerPthread::resize(unsigned workers) {
    const std::lock_guard<std::mutex> hold(m_lifecycle);
    const unsigned wanted = dxClampWorkers(workers);
    if (m_started.load() > wanted - 1) joinThreads();
    m_allowed.store(kMaxWorkers);
    m_size.store(wanted);
}

void dxThreadManagerPthread::run(unsigned blocks, unsigned maxWorkers, Task task, void *context) {
    const unsigned most = std::min({maxWorkers, blocks, m_size.load(), m_allowed.load()});
    if (most < 2) {
        dxRunAlone(blocks, task, context);
    } else {
        m_board.run({blocks, most - 1, task, context}, *this);
    }
}

void dxThreadManagerPthread::stop() {
    const std::lock_guard<std::mutex> hold(m_lifecycle);
    joinThreads();
    m_allowed.store(kMaxWorkers);
}

// The storage of a lock that another thread may have held is made a new lock.
void dxThreadManagerPthread::inForkedChild() {
    new (&m_lifecycle) std::mutex;
    new (&m_creation) std::mutex;
    m_started.store(0);
    m_numbered.store(0);
    m_isStopping.store(false);
    m_parking.reset();
    m_board.abandon();
}

// No more workers are called at once than there are other processors; each one that joins calls the next
// (passOnWakeUp). So a caller does not pay for waking workers that could only take its own processor.
void dxThreadManagerPthread::requestWorkers(unsigned wanted) {
    const unsigned atOnce = std::min(wanted, std::max(dxProcessorCount(), 2u) - 1);
    for (unsigned idle = m_parking.idle(); idle < atOnce && mayStartThread() && startThread(); ++idle) {
    }
    m_parking.wake(atOnce);
}

bool dxThreadManagerPthread::mayStartThread() const {
    return m_started.load() < std::min(m_size.load(), m_allowed.load()) - 1;
}

// A new worker counts as searching before it runs, so that the run that started it does not wake others.
bool dxThreadManagerPthread::startThread() {
    const std::lock_guard<std::mutex> hold(m_creation);
    if (m_isStopping.load() || !mayStartThread()) return false;
    const unsigned index = m_started.load();
    m_parking.beginSearch();
    const int refusal = dxStartThread(m_create, m_threads[index], threadBody, this, m_options);
    if (refusal == 0) {
        m_started.store(index + 1);
        dxLog(dxLogLevel::Info, "thread manager %s: started %s-%u", this->name(), m_options.name, index + 1);
        return true;
    }
    m_parking.endSearch();
    m_allowed.store(index + 1);
    if (!m_isReported) dxReportRefusal(this->name(), index + 1, m_size.load(), refusal);
    m_isReported = true;
    return false;
}

void dxThreadManagerPthread::joinThreads() {
    const dxNoCancellation whole;
    setStopping(true);
    m_parking.wakeAll();
    for (unsigned i = 0; i < m_started.load(); ++i) pthread_join(m_threads[i], nullptr);
    m_started.store(0);
    m_numbered.store(0);
    setStopping(false);
}

void dxThreadManagerPthread::setStopping(bool value) {
    const std::lock_guard<std::mutex> hold(m_creation);
    m_isStopping.store(value);
}

void *dxThreadManagerPthread::threadBody(void *manager) {
    dxThreadManagerPthread &own = *static_cast<dxThreadManagerPthread *>(manager);
    const unsigned number = ++own.m_numbered;
    own.becomeWorker(number);
    const dxWorkerHookScope hooks(own.m_options.hooks, number);
    own.serve();
    return nullptr;
}

void dxThreadManagerPthread::becomeWorker(unsigned number) {
    char threadName[dxWorkerOptions::kMaxName + 6];  // the kernel's limit
    std::snprintf(threadName, sizeof threadName, "%s-%u", m_options.name, number);
    pthread_setname_np(pthread_self(), threadName);
    if (!m_options.scheduling) return dxTakeProcessNiceness();
    if (const int refusal = m_options.scheduling->apply())
        dxLog(dxLogLevel::Warning, "thread manager %s: %s has ordinary scheduling (%s)", name(), threadName, std::strerror(refusal));
}

void dxThreadManagerPthread::serve() {
    dxAdaptiveSpin spin;
    while (!m_isStopping.load()) {
        workUntilIdle(spin);
        {
            const dxTimelineSpan sleeping(kSleeps);
            m_parking.park([this] { return shouldStayAwake(); }, [this] { endWithTheProcess(); });
        }
        spin.endWait();
    }
    m_parking.endSearch();
}

// Only as many workers spin as leave a processor to the caller.
void dxThreadManagerPthread::workUntilIdle(dxAdaptiveSpin &spin) {
    for (;;) {
        spin.beginWait();
        const auto mayStop = [this] { return shouldStayAwake(); };
        const bool maySpin = m_parking.searching() < dxProcessorCount();
        {
            const dxTimelineSpan spinning(kSpins);
            if (maySpin ? !dxSpinUntil(mayStop, spin.spinTime()) : !shouldStayAwake()) return;
        }
        spin.endWait();
        if (m_isStopping.load()) return;
        if (m_board.work([this] { passOnWakeUp(); })) m_parking.beginSearch();
    }
}

bool dxThreadManagerPthread::shouldStayAwake() { return m_board.hasWork() || m_isStopping.load(); }

// Whichever worker ends last ends the process, as the last thread of a process does.
void dxThreadManagerPthread::endWithTheProcess() {
    if (!dxMayBeLastThreads(m_started.load())) return;
    setStopping(true);
    m_parking.wakeAll();
}

// The last worker to stop searching calls another if there is work left: its run may want more than were
// called at once, and another run may have relied on it.
void dxThreadManagerPthread::passOnWakeUp() {
    m_parking.endSearch();
    if (m_parking.searching() == 0 && m_board.hasWork()) requestWorkers(1);
}
