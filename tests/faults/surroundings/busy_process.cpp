#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "surroundings.h"

namespace faults {

// Half a core for the caller and all workers: what waits must not keep it from what is waited for.
std::uint64_t besideBusyProcess() {
    const int core = sched_getcpu();
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(core >= 0 ? core : 0, &one);
    if (sched_setaffinity(0, sizeof one, &one) != 0) return 0;
    const pid_t busy = fork();
    if (busy == 0)
        for (volatile unsigned turns = 0;; turns = turns + 1) continue;
    const std::uint64_t hash = playFrames();
    kill(busy, SIGKILL);
    waitpid(busy, nullptr, 0);
    return hash;
}

}  // namespace faults
