// How the threads of dxThreadManagerPthread are started: what the program asks of them (dODE_MT_SetWorkerName and its like).
//
// Processors and stack are given to the system before a thread starts; scheduling and name the thread sets itself, as not all of
// them can be given before. So options are tried out on a thread of their own (dxTryWorker) before they are taken.
#pragma once

#include <pthread.h>
#include <sched.h>

#include <cstddef>
#include <optional>

#include "threading/pool/dxThreadCreation.h"
#include "threading/pool/dxWorkerHooks.h"

struct dxWorkerScheduling {
    int policy;    // SCHED_OTHER, SCHED_BATCH: the priority is the niceness
    int priority;

    // By the names that dODE_MT_SetWorkerPriority knows. Empty: no such name, or the priority is out of its range.
    static std::optional<dxWorkerScheduling> find(const char *name, int priority);
    static constexpr const char *kKnown = "normal and batch with -20 to 19, idle with 0, fifo and round-robin with 1 to 99";

    // Of the calling thread. Returns an error number.
    int apply() const;
};

struct dxWorkerOptions {
    // So that a number of four digits fits with it into the 15 characters that the kernel keeps.
    static constexpr std::size_t kMaxName = 10;
    static constexpr std::size_t kDefaultStack = std::size_t{8} << 20;  // bytes: ODE's solvers use alloca

    bool areDefault() const;

    char name[kMaxName + 1] = "ode_mt";
    std::optional<cpu_set_t> processors;           // empty: those of the process
    std::optional<dxWorkerScheduling> scheduling;  // empty: as the process's first thread, without its policy
    std::size_t stack = 0;                         // bytes, of whole pages; 0: kDefaultStack, or the system's default if larger
    dxWorkerHooks hooks;
};

// Whether the system starts a worker with these: starts one that has nothing to do. Returns an error number.
int dxTryWorker(const dxWorkerOptions &options, dxCreateThread create = pthread_create);
