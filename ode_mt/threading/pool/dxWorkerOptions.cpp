#include "threading/pool/dxWorkerOptions.h"

#include <sys/resource.h>

#include <cerrno>
#include <cstring>

#include "core/dxGuards.h"

namespace {

struct Scheduling {
    const char *name;
    int policy, least, most;
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

}  // namespace

std::optional<dxWorkerScheduling> dxWorkerScheduling::find(const char *name, int priority) {
    for (const Scheduling &known : kSchedulings) {
        if (std::strcmp(name, known.name) != 0) continue;
        if (priority < known.least || priority > known.most) return std::nullopt;
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

int dxTryWorker(const dxWorkerOptions &options, dxCreateThread create) {
    const dxNoCancellation whole;
    Trial trial{options};
    const auto body = [](void *of) -> void * {
        Trial &tried = *static_cast<Trial *>(of);
        if (tried.options.scheduling) tried.refusal = tried.options.scheduling->apply();
        return nullptr;
    };
    pthread_t thread;
    const int refusal = dxStartThread(create, thread, body, &trial, options, dxIfRefused::Fail);
    if (refusal != 0) return refusal;
    pthread_join(thread, nullptr);
    return trial.refusal;
}
