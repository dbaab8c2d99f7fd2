#include "threading/pool/dxLastThreads.h"

#include <fcntl.h>
#include <sys/uio.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace {

// A thread that has ended has no memory any more, its own process may look into which.
bool hasFirstThreadEnded() {
    char from = 0, to = 0;
    const iovec source{&from, 1}, target{&to, 1};
    return process_vm_readv(getpid(), &target, 1, &source, 1, 0) < 0 && errno == ESRCH;
}

}  // namespace

// proc(5): the state of the process is that of its first thread, Z once that has ended; it counts as a thread until the
// process ends. The name in parentheses may hold anything.
bool dxMayBeLastThreads(unsigned threads) {
    char text[1024];
    const int file = open("/proc/self/stat", O_RDONLY | O_CLOEXEC);
    if (file < 0) return hasFirstThreadEnded();
    const ssize_t length = read(file, text, sizeof text - 1);
    close(file);
    if (length <= 0) return hasFirstThreadEnded();
    text[length] = '\0';
    const char *const afterName = std::strrchr(text, ')');
    char state = 0;
    unsigned count = 0;
    return afterName != nullptr &&
           std::sscanf(afterName + 1, " %c %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %u", &state,
                       &count) == 2 &&
           state == 'Z' && count == threads + 1;
}
