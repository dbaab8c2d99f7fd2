#include "threading/process/dxProcessors.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <thread>

namespace {

// Written before any thread can ask.
cpu_set_t atLoading;
bool isKnown = false;

std::atomic<unsigned> lastCount{0};  // 0: not counted yet

// Adds those of a thread; 0: the calling one. The first thread of a process has its number.
bool addThose(pid_t thread, cpu_set_t &processors) {
    cpu_set_t own;
    CPU_ZERO(&own);
    if (sched_getaffinity(thread, sizeof own, &own) != 0) return false;
    CPU_OR(&processors, &processors, &own);
    return true;
}

__attribute__((constructor)) void lookWhenLoaded() {
    CPU_ZERO(&atLoading);
    isKnown = addThose(getpid(), atLoading);
}

}  // namespace

bool dxProcessorsOfProcess(cpu_set_t &processors) {
    processors = atLoading;
    const bool first = addThose(getpid(), processors), calling = addThose(0, processors);
    return isKnown || first || calling;
}

unsigned dxCountProcessors() {
    cpu_set_t processors;
    const unsigned count = dxProcessorsOfProcess(processors) ? static_cast<unsigned>(CPU_COUNT(&processors))
                                                             : std::thread::hardware_concurrency();
    lastCount.store(std::max(count, 1u), std::memory_order_relaxed);
    return std::max(count, 1u);
}

unsigned dxProcessorCount() {
    const unsigned count = lastCount.load(std::memory_order_relaxed);
    return count != 0 ? count : dxCountProcessors();
}
