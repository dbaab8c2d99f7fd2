#include "threading/pool/dxLastThreads.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>

namespace {

// A thread that has ended has no memory any more, its own process may look into which.
bool hasFirstThreadEnded() {
    char from = 0, to = 0;
    const iovec source{&from, 1}, target{&to, 1};
    return process_vm_readv(getpid(), &target, 1, &source, 1, 0) < 0 && errno == ESRCH;
}

// A short file of the system's. Returns its length; 0: it tells nothing.
std::size_t readFile(const char *name, char (&text)[1024]) {
    const int file = open(name, O_RDONLY | O_CLOEXEC);
    if (file < 0) return 0;
    const ssize_t length = read(file, text, sizeof text - 1);
    close(file);
    text[std::max<ssize_t>(length, 0)] = '\0';
    return static_cast<std::size_t>(std::max<ssize_t>(length, 0));
}

// proc(5): the state of the process is that of its first thread, Z once that has ended; it counts as a thread until the
// process ends. The name in parentheses may hold anything.
bool hasFirstThreadEnded(const char *stat, unsigned &threads) {
    const char *const afterName = std::strrchr(stat, ')');
    char state = 0;
    return afterName != nullptr &&
           std::sscanf(afterName + 1, " %c %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %u", &state,
                       &threads) == 2 &&
           state == 'Z';
}

// One that has just ended is none of others.
bool isOneOf(const char *thread, const std::vector<std::string> &names) {
    char text[1024];
    if (readFile((std::string("/proc/self/task/") + thread + "/comm").c_str(), text) == 0) return true;
    return std::any_of(names.begin(), names.end(), [&text](const std::string &name) { return std::strncmp(text, name.c_str(), name.size()) == 0; });
}

}  // namespace

bool dxMayBeLastThreads(unsigned threads) {
    char text[1024];
    if (readFile("/proc/self/stat", text) == 0) return hasFirstThreadEnded();
    unsigned count = 0;
    return hasFirstThreadEnded(text, count) && count == threads + 1;
}

bool dxAreLastThreads(const std::vector<std::string> &names) {
    char text[1024];
    unsigned count = 0;
    if (readFile("/proc/self/stat", text) == 0 || !hasFirstThreadEnded(text, count)) return false;
    const std::unique_ptr<DIR, int (*)(DIR *)> threads(opendir("/proc/self/task"), closedir);
    if (!threads) return false;
    while (const dirent *const entry = readdir(threads.get())) {
        const bool isThread = entry->d_name[0] != '.' && std::atoi(entry->d_name) != getpid();
        if (isThread && !isOneOf(entry->d_name, names)) return false;
    }
    return true;
}
