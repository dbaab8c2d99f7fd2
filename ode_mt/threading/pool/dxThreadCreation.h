// Starting threads, and finding out how many the system allows.
#pragma once

#include <pthread.h>

// The signature of pthread_create; tests put one here that fails.
using dxCreateThread = int (*)(pthread_t *, const pthread_attr_t *, void *(*)(void *), void *);

constexpr unsigned dxMaxWorkers = 1024;

// The nearest number of workers that a manager accepts.
inline unsigned dxClampWorkers(unsigned workers) {
    return workers < 1 ? 1 : workers > dxMaxWorkers ? dxMaxWorkers : workers;
}

struct dxWorkerOptions;

enum class dxIfRefused { Inherit, Fail };

// Starts one worker thread: joinable, with all signals blocked but those a fault raises on the thread itself, which must reach the
// host's crash handler. Its stack and its processors are those of the options; it has ordinary scheduling, whatever the
// starting thread has bound itself to. Where the system refuses that, the thread inherits processors and scheduling, or is not
// started. Returns an error number.
int dxStartThread(dxCreateThread create, pthread_t &thread, void *(*body)(void *), void *context, const dxWorkerOptions &options,
                  dxIfRefused ifRefused = dxIfRefused::Inherit);

// Gives the calling thread, which inherited its niceness from the one that started it, that of the process's first
// thread, as far as the system allows: to lower it needs a privilege.
void dxTakeProcessNiceness();

// How many threads, at most `wanted`, the system lets exist at the same time beside those there are.
// Starts and ends them. `refusal` is the error number of the first one refused, else 0.
unsigned dxProbeThreads(dxCreateThread create, unsigned wanted, int &refusal);

// Says that there are fewer workers than wanted.
void dxReportRefusal(const char *manager, unsigned workers, unsigned wanted, int refusal);
