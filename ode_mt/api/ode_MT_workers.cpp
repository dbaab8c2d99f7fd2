// Functions of ode/ode_MT.h about workers: how many a world and a space may use, which of them calls, whose threads they are, and how those
// of the library start.
#include <ode/error.h>
#include <ode/ode_MT.h>

#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <new>

#include "collision/callbacks/dxConcurrentCallbacks.h"
#include "collision/dxSpaceCollision.h"
#include "collision/spaces/dxOrderedSpace.h"
#include "error.h"
#include "settings/dxSettings.h"
#include "settings/dxWorkers.h"
#include "settings/dxWorldState.h"

namespace {

bool choose(const dxWorld *world, unsigned threads) try {
    dxSetThreads(world, threads);
    return true;
} catch (const std::bad_alloc &) {
    return false;
}

// A hook sets no other number: that would end workers.
bool maySet(unsigned threads, unsigned before) { return threads == before || dxWorkers::instance().mayEndWorkers(); }

int change(const char *what, const std::function<void(dxWorkerOptions &)> &change) {
    return dxWorkers::instance().changeOptions(what, change) ? 1 : 0;
}

// Returns whether all are numbers of processors; the first that is not is reported.
bool readProcessors(const int *processors, int count, cpu_set_t &set) {
    const long known = std::min<long>(sysconf(_SC_NPROCESSORS_CONF), CPU_SETSIZE);
    CPU_ZERO(&set);
    for (int i = 0; i < count; ++i) {
        if (processors[i] < 0 || processors[i] >= known) {
            dMessage(0, "ODE_MT: no processor %d; known: 0 to %ld", processors[i], known - 1);
            return false;
        }
        CPU_SET(processors[i], &set);
    }
    return true;
}

std::size_t roundToPages(std::size_t bytes) {
    const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    return (bytes + page - 1) / page * page;
}

}  // namespace

extern "C" {

int dODE_MT_SetWorldThreads(dWorldID world, int numThreads) {
    dUASSERT(world, "bad world argument");
    const unsigned threads = dxSettings::instance().resolveThreads(numThreads);
    if (!maySet(threads, dxWorldSettings::of(world).threads)) return 0;
    const bool isChosen = choose(world, threads);
    if (!isChosen) dMessage(0, "ODE_MT: no memory to note the number of threads of a world");
    dxWorkers::instance().resize();
    return isChosen ? 1 : 0;
}

int dODE_MT_GetWorldThreads(dWorldID world) {
    dUASSERT(world, "bad world argument");
    return static_cast<int>(dxWorldSettings::of(world).threadsInForce());
}

void dODE_MT_SetSpaceThreads(dSpaceID space, int numThreads) {
    dUASSERT(space && dGeomIsSpace(space), "bad space argument");
    const unsigned threads = dxSettings::instance().resolveThreads(numThreads);
    if (dxOrderedSpace *const own = dxOrderedSpace::from(space)) {
        if (!maySet(threads, own->ownThreads().own())) return;
        own->ownThreads().choose(threads);
    }
    dxWorkers::instance().resize();
}

int dODE_MT_GetSpaceThreads(dSpaceID space) {
    dUASSERT(space && dGeomIsSpace(space), "bad space argument");
    const dxOrderedSpace *const own = dxOrderedSpace::from(space);
    return static_cast<int>(own != nullptr ? own->ownThreads().inForce() : dxSettings::instance().threads());
}

int dODE_MT_GetWorkerIndex() {
    const dxContactLog *const log = dxContactLog::current();
    return log != nullptr ? static_cast<int>(log->worker()) : 0;
}

int dODE_MT_GetWorkerCount(dSpaceID space) {
    dUASSERT(space && dGeomIsSpace(space), "bad space argument");
    const dxOrderedSpace *const own = dxOrderedSpace::from(space);
    return own != nullptr ? static_cast<int>(dxMaxCollisionThreads(*own)) : 1;
}

void dODE_MT_SetExecutor(dODE_MT_PostFunction *post, void *context) {
    dxThreadLender lender;
    lender.executor = post;
    if (post != nullptr) lender.context = context;
    dxWorkers::instance().lend(lender);
}

int dODE_MT_SetThreadingImplementation(const dThreadingFunctionsInfo *functions, dThreadingImplementationID implementation) {
    if ((functions == nullptr) != (implementation == nullptr)) {
        dMessage(0, "ODE_MT: a threading implementation without %s (NULL)", functions == nullptr ? "functions" : "implementation");
        return 0;
    }
    return dxWorkers::instance().lend({functions, implementation, nullptr, nullptr}) ? 1 : 0;
}

int dODE_MT_SetWorkerName(const char *name) {
    const char *const text = name != nullptr ? name : "ode_mt";
    const std::size_t length = std::strlen(text);
    if (length == 0 || length > dxWorkerOptions::kMaxName) {
        dMessage(0, "ODE_MT: no worker name '%.100s'; known: 1 to %d characters", text, static_cast<int>(dxWorkerOptions::kMaxName));
        return 0;
    }
    return change("the name of workers", [text](dxWorkerOptions &options) { std::strcpy(options.name, text); });
}

int dODE_MT_SetWorkerAffinity(const int *processors, int count) {
    if (count < 0 || count > CPU_SETSIZE || (count > 0 && processors == nullptr)) {
        dMessage(0, "ODE_MT: no list of %d processors%s; known: 0 to %d", count, processors == nullptr ? " (NULL)" : "", CPU_SETSIZE);
        return 0;
    }
    cpu_set_t set;
    if (!readProcessors(processors, count, set)) return 0;
    const cpu_set_t *const wanted = count > 0 ? &set : nullptr;
    return change("the processors of workers", [wanted](dxWorkerOptions &options) {
        options.processors = wanted != nullptr ? std::optional(*wanted) : std::nullopt;
    });
}

int dODE_MT_SetWorkerPriority(const char *scheduling, int priority) {
    std::optional<dxWorkerScheduling> wanted;
    if (scheduling != nullptr) {
        wanted = dxWorkerScheduling::find(scheduling, priority);
        if (!wanted) {
            dMessage(0, "ODE_MT: no worker priority '%.100s' with %d; known: %s", scheduling, priority, dxWorkerScheduling::kKnown);
            return 0;
        }
    }
    return change("the priority of workers", [&wanted](dxWorkerOptions &options) { options.scheduling = wanted; });
}

int dODE_MT_SetWorkerStackSize(size_t bytes) {
    if ((bytes != 0 && bytes < dODE_MT_MIN_STACK_SIZE) || bytes > PTRDIFF_MAX) {
        dMessage(0, "ODE_MT: no worker stack of %zu bytes; known: 0, or %d and more", bytes, dODE_MT_MIN_STACK_SIZE);
        return 0;
    }
    return change("the stack size of workers", [stack = roundToPages(bytes)](dxWorkerOptions &options) { options.stack = stack; });
}

int dODE_MT_SetWorkerHooks(dODE_MT_WorkerHook *start, dODE_MT_WorkerHook *end, void *data) {
    const dxWorkerHooks hooks{start, end, data};
    return change("hooks of workers", [&hooks](dxWorkerOptions &options) { options.hooks = hooks; });
}

}  // extern "C"
