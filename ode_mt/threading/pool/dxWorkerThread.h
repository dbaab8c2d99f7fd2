// How a worker thread of dxThreadManagerPthread starts and ends: with the options and hooks of the program (dODE_MT_SetWorkerName and its like), and
// as far as the system allows threads.
//
// Processors and stack are given to the system before a thread starts. The thread sets scheduling and name itself, as not all of them can be given
// before. So options are tried on a thread of their own (dxTryWorker) before they are taken.
//
// Threading: any thread.
#pragma once

#include <pthread.h>
#include <sched.h>

#include <cstddef>
#include <optional>

// The signature of pthread_create; tests put one here that fails.
using dxCreateThread = int (*)(pthread_t *, const pthread_attr_t *, void *(*)(void *), void *);

constexpr unsigned kMaxWorkers = 1024;

// Returns the nearest number of workers that a manager accepts.
inline unsigned dxClampWorkers(unsigned workers) {
    return workers < 1 ? 1 : workers > kMaxWorkers ? kMaxWorkers : workers;
}

// Functions of the program that each worker calls when it starts and when it ends (dODE_MT_SetWorkerHooks).
//
// A hook runs on its worker outside of every run, where nothing keeps the manager: if it ended the workers, its thread would wait for itself. So
// code that ends or lends workers asks whether the calling thread is in a hook.
struct dxWorkerHooks {
    using Hook = void (*)(void *data, int worker);

    // Returns whether the calling thread is in one.
    static bool isInside();

    Hook start = nullptr, end = nullptr;
    void *data = nullptr;
};

// Calls the hooks of the calling thread: `start` when it is made, `end` by whatever way the thread leaves its scope.
class dxWorkerHookScope {
public:
    dxWorkerHookScope(const dxWorkerHooks &hooks, unsigned worker);
    ~dxWorkerHookScope();
    dxWorkerHookScope(const dxWorkerHookScope &) = delete;
    dxWorkerHookScope &operator=(const dxWorkerHookScope &) = delete;

private:
    void call(dxWorkerHooks::Hook hook) const;

    const dxWorkerHooks m_hooks;
    const int m_worker;
};

struct dxWorkerScheduling {
    int policy;    // SCHED_OTHER, SCHED_BATCH: the priority is the niceness
    int priority;

    // Finds a scheduling by a name that dODE_MT_SetWorkerPriority knows. Returns none for another name, or if the priority is out of its range.
    static std::optional<dxWorkerScheduling> find(const char *name, int priority);
    static constexpr const char *kKnown = "normal and batch with -20 to 19, idle with 0, fifo and round-robin with 1 to 99";

    // Sets the scheduling of the calling thread. Returns an error number.
    int apply() const;
};

struct dxWorkerOptions {
    // With a number of four digits, a name fits into the 15 characters that the kernel keeps.
    static constexpr std::size_t kMaxName = 10;
    static constexpr std::size_t kDefaultStack = std::size_t{8} << 20;  // bytes: ODE's solvers use alloca

    bool areDefault() const;

    char name[kMaxName + 1] = "ode_mt";
    std::optional<cpu_set_t> processors;           // empty: those of the process
    std::optional<dxWorkerScheduling> scheduling;  // empty: as the process's first thread, without its policy
    std::size_t stack = 0;                         // bytes, of whole pages; 0: kDefaultStack, or the system's default if larger
    dxWorkerHooks hooks;
};

// Starts one thread: joinable, with all signals blocked but those that a fault raises on the thread itself, which must reach the host's crash
// handler. Its stack and its processors are those of the options. It has ordinary scheduling, whatever the starting thread has bound itself to. Where
// the system refuses that, the thread inherits processors and scheduling. Returns an error number.
int dxStartThread(dxCreateThread create, pthread_t &thread, void *(*body)(void *), void *context, const dxWorkerOptions &options);

// Gives the calling thread, which inherited its niceness from the one that started it, that of the process's first
// thread, as far as the system allows: to lower it needs a privilege.
void dxTakeProcessNiceness();

// Tries the options on a worker that does nothing. Returns an error number.
int dxTryWorker(const dxWorkerOptions &options, dxCreateThread create = pthread_create);

// Returns how many threads, at most `wanted`, the system lets exist at the same time beside those there are. Starts and ends them. Sets `refusal` to
// the error number of the first one refused, or to 0.
unsigned dxProbeThreads(dxCreateThread create, unsigned wanted, int &refusal);

// Reports that there are fewer workers than wanted.
void dxReportRefusal(const char *manager, unsigned workers, unsigned wanted, int refusal);
