#include "batch/child.h"

#include <sys/prctl.h>
#include <unistd.h>

#include <csignal>
#include <cstdarg>

namespace batch {

namespace {

void ignoreMessage(int, const char *, va_list) {}

}  // namespace

pid_t forkChild() {
    const pid_t parent = getpid(), child = fork();
    if (child == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (getppid() != parent) _exit(0);  // it has ended before
    }
    return child;
}

void initialiseOde(dMessageFunction *endByError) {
    dInitODE2(0);
    dSetErrorHandler(endByError);
    dSetDebugHandler(endByError);
    dSetMessageHandler(ignoreMessage);
}

}  // namespace batch
