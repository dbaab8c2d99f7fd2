#include "threading/managers/dxThreadManagerPthread.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <new>

#include "core/dxGuards.h"
#include "core/dxLog.h"
#include "threading/pool/dxLastThreads.h"
#include "threading/pool/dxSpin.h"
#include "threading/timeline/dxTimelineSpan.h"

namespace {

constexpr dxTimelineEvent kSpins{"spins", "idle", {}, dxTimelineEvent::Kind::Idle};
constexpr dxTimelineEvent kSleeps{"sleeps", "idle", {}, dxTimelineEvent::Kind::Idle};

}  // namespace

dxThreadManagerPthread::dxThreadManagerPthread(dxCreateThread creation, const dxWorkerOptions &workerOptions)
    : create(creation), options(workerOptions) {
    listenToForks();
}

dxThreadManagerPthread::~dxThreadManagerPthread() {
    ignoreForks();
    stop();
}

void dxThreadManagerPthread::resize(unsigned workers) {
    const std::lock_guard<std::mutex> hold(lifecycle);
    const unsigned wanted = dxClampWorkers(workers);
    if (started.load() > wanted - 1) joinThreads();
    allowed.store(dxMaxWorkers);
    size.store(wanted);
}

void dxThreadManagerPthread::run(unsigned blocks, unsigned maxWorkers, Task task, void *context) {
    const unsigned most = std::min({maxWorkers, blocks, size.load(), allowed.load()});
    if (most < 2) {
        dxRunAlone(blocks, task, context);
    } else {
        board.run({blocks, most - 1, task, context}, *this);
    }
}

void dxThreadManagerPthread::stop() {
    const std::lock_guard<std::mutex> hold(lifecycle);
    joinThreads();
    allowed.store(dxMaxWorkers);
}

// The storage of a lock that another thread may have held is made a new lock.
void dxThreadManagerPthread::inForkedChild() {
    new (&lifecycle) std::mutex;
    new (&creation) std::mutex;
    started.store(0);
    numbered.store(0);
    stopping.store(false);
    parking.reset();
    board.abandon();
}

// No more workers are called at once than there are other processors; each one that joins calls the next
// (passOnWakeUp). So a caller does not pay for waking workers that could only take its own processor.
void dxThreadManagerPthread::requestWorkers(unsigned wanted) {
    const unsigned atOnce = std::min(wanted, std::max(dxProcessorCount(), 2u) - 1);
    for (unsigned idle = parking.idle(); idle < atOnce && mayStartThread() && startThread(); ++idle) {
    }
    parking.wake(atOnce);
}

bool dxThreadManagerPthread::mayStartThread() const {
    return started.load() < std::min(size.load(), allowed.load()) - 1;
}

// A new worker counts as searching before it runs, so that the run that started it does not wake others.
bool dxThreadManagerPthread::startThread() {
    const std::lock_guard<std::mutex> hold(creation);
    if (stopping.load() || !mayStartThread()) return false;
    const unsigned index = started.load();
    parking.beginSearch();
    const int refusal = dxStartThread(create, threads[index], threadBody, this, options);
    if (refusal == 0) {
        started.store(index + 1);
        dxLog(dxLogLevel::info, "thread manager %s: started %s-%u", this->name(), options.name, index + 1);
        return true;
    }
    parking.endSearch();
    allowed.store(index + 1);
    if (!reported) dxReportRefusal(this->name(), index + 1, size.load(), refusal);
    reported = true;
    return false;
}

void dxThreadManagerPthread::joinThreads() {
    const dxNoCancellation whole;
    setStopping(true);
    parking.wakeAll();
    for (unsigned i = 0; i < started.load(); ++i) pthread_join(threads[i], nullptr);
    started.store(0);
    numbered.store(0);
    setStopping(false);
}

void dxThreadManagerPthread::setStopping(bool value) {
    const std::lock_guard<std::mutex> hold(creation);
    stopping.store(value);
}

void *dxThreadManagerPthread::threadBody(void *manager) {
    dxThreadManagerPthread &own = *static_cast<dxThreadManagerPthread *>(manager);
    const unsigned number = ++own.numbered;
    own.becomeWorker(number);
    const dxWorkerHookScope hooks(own.options.hooks, number);
    own.serve();
    return nullptr;
}

void dxThreadManagerPthread::becomeWorker(unsigned number) {
    char threadName[dxWorkerOptions::kMaxName + 6];  // the kernel's limit
    std::snprintf(threadName, sizeof threadName, "%s-%u", options.name, number);
    pthread_setname_np(pthread_self(), threadName);
    if (!options.scheduling) return dxTakeProcessNiceness();
    if (const int refusal = options.scheduling->apply())
        dxLog(dxLogLevel::warning, "thread manager %s: %s has ordinary scheduling (%s)", name(), threadName, std::strerror(refusal));
}

void dxThreadManagerPthread::serve() {
    dxAdaptiveSpin spin;
    while (!stopping.load()) {
        workUntilIdle(spin);
        {
            const dxTimelineSpan sleeping(kSleeps);
            parking.park([this] { return shouldStayAwake(); }, [this] { endWithTheProcess(); });
        }
        spin.endWait();
    }
    parking.endSearch();
}

// Only as many workers spin as leave a processor to the caller.
void dxThreadManagerPthread::workUntilIdle(dxAdaptiveSpin &spin) {
    for (;;) {
        spin.beginWait();
        const auto mayStop = [this] { return shouldStayAwake(); };
        const bool maySpin = parking.searching() < dxProcessorCount();
        {
            const dxTimelineSpan spinning(kSpins);
            if (maySpin ? !dxSpinUntil(mayStop, spin.spinTime()) : !shouldStayAwake()) return;
        }
        spin.endWait();
        if (stopping.load()) return;
        if (board.work([this] { passOnWakeUp(); })) parking.beginSearch();
    }
}

bool dxThreadManagerPthread::shouldStayAwake() { return board.hasWork() || stopping.load(); }

// Whichever worker ends last ends the process, as the last thread of a process does.
void dxThreadManagerPthread::endWithTheProcess() {
    if (!dxMayBeLastThreads(started.load())) return;
    setStopping(true);
    parking.wakeAll();
}

// The last worker to stop searching calls another if there is work left: its run may want more than were
// called at once, and another run may have relied on it.
void dxThreadManagerPthread::passOnWakeUp() {
    parking.endSearch();
    if (parking.searching() == 0 && board.hasWork()) requestWorkers(1);
}
