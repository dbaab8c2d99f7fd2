#include "threading/pool/dxWorkerThread.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <mutex>
#include <vector>

#include "core/dxGuards.h"
#include "core/dxLog.h"
#include "threading/process/dxProcessors.h"

namespace {

__attribute__((tls_model("initial-exec"))) thread_local bool t_isInHook = false;

struct Scheduling {
    const char *name;
    int policy, min, max;
};

constexpr Scheduling kSchedulings[] = {{"normal", SCHED_OTHER, -20, 19},
                                       {"batch", SCHED_BATCH, -20, 19},
                                       {"idle", SCHED_IDLE, 0, 0},
                                       {"fifo", SCHED_FIFO, 1, 99},
                                       {"round-robin", SCHED_RR, 1, 99}};

bool isByNiceness(int policy) { return policy == SCHED_OTHER || policy == SCHED_BATCH; }

struct Trial {
    const dxWorkerOptions &options;
    int refusal = 0;
};

class Attributes {
public:
    explicit Attributes(const dxWorkerOptions &options) {
        pthread_attr_init(&m_attributes);
        std::size_t size = 0;
        pthread_attr_getstacksize(&m_attributes, &size);
        pthread_attr_setstacksize(&m_attributes, options.stack != 0 ? options.stack : std::max(size, dxWorkerOptions::kDefaultStack));
    }
    ~Attributes() { pthread_attr_destroy(&m_attributes); }

    // Replaces what the starting thread has by the processors of the options, or of the process, and by ordinary scheduling.
    void becomeOrdinary(const dxWorkerOptions &options) {
        cpu_set_t processors;
        if (options.processors)
            pthread_attr_setaffinity_np(&m_attributes, sizeof processors, &*options.processors);
        else if (dxProcessorsOfProcess(processors))
            pthread_attr_setaffinity_np(&m_attributes, sizeof processors, &processors);
        const sched_param priority{};
        pthread_attr_setinheritsched(&m_attributes, PTHREAD_EXPLICIT_SCHED);
        pthread_attr_setschedpolicy(&m_attributes, SCHED_OTHER);
        pthread_attr_setschedparam(&m_attributes, &priority);
    }

    const pthread_attr_t *get() const { return &m_attributes; }

private:
    pthread_attr_t m_attributes;
};

// Starts a thread with ordinary scheduling, or returns an error number.
int startOrdinary(dxCreateThread create, pthread_t &thread, void *(*body)(void *), void *context, const dxWorkerOptions &options) {
    const dxBlockedSignals blocked;
    Attributes attributes(options);
    attributes.becomeOrdinary(options);
    return create(&thread, attributes.get(), body, context);
}

// Returns that of one thread; 0: the calling one. The first thread of a process has the number of the process.
int nicenessOf(id_t thread) { return getpriority(PRIO_PROCESS, thread); }

void *waitForGate(void *gate) {
    const std::lock_guard<std::mutex> pass(*static_cast<std::mutex *>(gate));
    return nullptr;
}

}  // namespace

bool dxWorkerHooks::isInside() { return t_isInHook; }

dxWorkerHookScope::dxWorkerHookScope(const dxWorkerHooks &hooks, unsigned worker) : m_hooks(hooks), m_worker(static_cast<int>(worker)) {
    call(m_hooks.start);
}

dxWorkerHookScope::~dxWorkerHookScope() { call(m_hooks.end); }

void dxWorkerHookScope::call(dxWorkerHooks::Hook hook) const {
    if (hook == nullptr) return;
    t_isInHook = true;
    hook(m_hooks.data, m_worker);
    t_isInHook = false;
}

std::optional<dxWorkerScheduling> dxWorkerScheduling::find(const char *name, int priority) {
    for (const Scheduling &known : kSchedulings) {
        if (std::strcmp(name, known.name) != 0) continue;
        if (priority < known.min || priority > known.max) return std::nullopt;
        return dxWorkerScheduling{known.policy, priority};
    }
    return std::nullopt;
}

int dxWorkerScheduling::apply() const {
    sched_param parameters{};
    parameters.sched_priority = isByNiceness(policy) ? 0 : priority;
    if (sched_setscheduler(0, policy, &parameters) != 0) return errno;
    return isByNiceness(policy) && setpriority(PRIO_PROCESS, 0, priority) != 0 ? errno : 0;
}

bool dxWorkerOptions::areDefault() const {
    return std::strcmp(name, dxWorkerOptions().name) == 0 && !processors && !scheduling && stack == 0 && hooks.start == nullptr &&
           hooks.end == nullptr;
}

int dxStartThread(dxCreateThread create, pthread_t &thread, void *(*body)(void *), void *context, const dxWorkerOptions &options) {
    const int refusal = startOrdinary(create, thread, body, context, options);
    if (refusal != EPERM && refusal != EINVAL) return refusal;
    dxLog(dxLogLevel::Info, "a worker thread inherits processors and scheduling (%s)", std::strerror(refusal));
    const dxBlockedSignals blocked;
    const Attributes inherited(options);
    return create(&thread, inherited.get(), body, context);
}

void dxTakeProcessNiceness() {
    const int niceness = nicenessOf(static_cast<id_t>(getpid()));
    if (niceness != nicenessOf(0)) setpriority(PRIO_PROCESS, 0, niceness);
}

int dxTryWorker(const dxWorkerOptions &options, dxCreateThread create) {
    const dxNoCancellation whole;
    Trial trial{options};
    const auto body = [](void *of) -> void * {
        Trial &tried = *static_cast<Trial *>(of);
        if (tried.options.scheduling) tried.refusal = tried.options.scheduling->apply();
        return nullptr;
    };
    pthread_t thread;
    const int refusal = startOrdinary(create, thread, body, &trial, options);
    if (refusal != 0) return refusal;
    pthread_join(thread, nullptr);
    return trial.refusal;
}

unsigned dxProbeThreads(dxCreateThread create, unsigned wanted, int &refusal) {
    const dxNoCancellation whole;
    std::vector<pthread_t> threads;
    threads.reserve(wanted);
    std::mutex gate;
    {
        const std::lock_guard<std::mutex> closed(gate);
        refusal = 0;
        while (threads.size() < wanted) {
            pthread_t thread;
            refusal = dxStartThread(create, thread, waitForGate, &gate, dxWorkerOptions());
            if (refusal != 0) break;
            threads.push_back(thread);
        }
    }
    for (const pthread_t thread : threads) pthread_join(thread, nullptr);
    return static_cast<unsigned>(threads.size());
}

void dxReportRefusal(const char *manager, unsigned workers, unsigned wanted, int refusal) {
    dxLog(dxLogLevel::Warning,
          "thread manager %s: the system refused a thread (%s); %u of %u workers, the caller included, are "
          "used",
          manager, std::strerror(refusal), workers, wanted);
}
