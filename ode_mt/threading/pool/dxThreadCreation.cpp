#include "threading/pool/dxThreadCreation.h"

#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <mutex>
#include <vector>

#include "core/dxGuards.h"
#include "core/dxLog.h"
#include "threading/pool/dxWorkerOptions.h"
#include "threading/process/dxProcessors.h"

namespace {

class Attributes {
public:
    explicit Attributes(const dxWorkerOptions &options) {
        pthread_attr_init(&attributes);
        std::size_t size = 0;
        pthread_attr_getstacksize(&attributes, &size);
        pthread_attr_setstacksize(&attributes, options.stack != 0 ? options.stack : std::max(size, dxWorkerOptions::kDefaultStack));
    }
    ~Attributes() { pthread_attr_destroy(&attributes); }

    // Instead of what the starting thread has: the processors of the options, or of the process, and ordinary scheduling.
    void becomeOrdinary(const dxWorkerOptions &options) {
        cpu_set_t processors;
        if (options.processors)
            pthread_attr_setaffinity_np(&attributes, sizeof processors, &*options.processors);
        else if (dxProcessorsOfProcess(processors))
            pthread_attr_setaffinity_np(&attributes, sizeof processors, &processors);
        const sched_param priority{};
        pthread_attr_setinheritsched(&attributes, PTHREAD_EXPLICIT_SCHED);
        pthread_attr_setschedpolicy(&attributes, SCHED_OTHER);
        pthread_attr_setschedparam(&attributes, &priority);
    }

    const pthread_attr_t *get() const { return &attributes; }

private:
    pthread_attr_t attributes;
};

// Of one thread; 0: the calling one. The first thread of a process has its number.
int nicenessOf(id_t thread) { return getpriority(PRIO_PROCESS, thread); }

void *waitForGate(void *gate) {
    const std::lock_guard<std::mutex> pass(*static_cast<std::mutex *>(gate));
    return nullptr;
}

}  // namespace

int dxStartThread(dxCreateThread create, pthread_t &thread, void *(*body)(void *), void *context, const dxWorkerOptions &options,
                  dxIfRefused ifRefused) {
    const dxBlockedSignals blocked;
    Attributes attributes(options);
    attributes.becomeOrdinary(options);
    const int refusal = create(&thread, attributes.get(), body, context);
    if (ifRefused == dxIfRefused::Fail || (refusal != EPERM && refusal != EINVAL)) return refusal;
    dxLog(dxLogLevel::info, "a worker thread inherits processors and scheduling (%s)", std::strerror(refusal));
    const Attributes inherited(options);
    return create(&thread, inherited.get(), body, context);
}

void dxTakeProcessNiceness() {
    const int niceness = nicenessOf(static_cast<id_t>(getpid()));
    if (niceness != nicenessOf(0)) setpriority(PRIO_PROCESS, 0, niceness);
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
    dxLog(dxLogLevel::warning,
          "thread manager %s: the system refused a thread (%s); %u of %u workers, the caller included, are "
          "used",
          manager, std::strerror(refusal), workers, wanted);
}
