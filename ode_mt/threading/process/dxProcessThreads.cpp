#include "threading/process/dxProcessThreads.h"

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

// The system finds no memory of a thread that has ended. A process may ask for its own.
bool hasFirstThreadEnded() {
    char from = 0, to = 0;
    const iovec source{&from, 1}, target{&to, 1};
    return process_vm_readv(getpid(), &target, 1, &source, 1, 0) < 0 && errno == ESRCH;
}

// proc(5): the state of the process is that of its first thread, Z once that has ended; it counts as a thread until the
// process ends. The name in parentheses may hold any characters. Returns false if the system does not tell.
bool readProcess(char &state, unsigned &threads) {
    char text[1024];
    const int file = open("/proc/self/stat", O_RDONLY | O_CLOEXEC);
    if (file < 0) return false;
    const ssize_t length = read(file, text, sizeof text - 1);
    close(file);
    if (length <= 0) return false;
    text[length] = '\0';
    const char *const afterName = std::strrchr(text, ')');
    return afterName != nullptr &&
           std::sscanf(afterName + 1, " %c %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %u", &state,
                       &threads) == 2;
}

// Returns false for a thread whose name the system does not tell, as it has just ended or no descriptor is free.
bool isOneOf(const char *thread, const std::vector<std::string> &names) {
    std::string own;
    return dxReadThreadName(static_cast<std::uint32_t>(std::atoi(thread)), own) &&
           std::any_of(names.begin(), names.end(), [&own](const std::string &name) { return own.compare(0, name.size(), name) == 0; });
}

}  // namespace

bool dxReadThreadName(std::uint32_t thread, std::string &name) {
    char path[64], line[kThreadNameSize + 1] = "";
    std::snprintf(path, sizeof path, "/proc/self/task/%u/comm", thread);
    std::FILE *const file = std::fopen(path, "re");
    if (file == nullptr) return false;
    const std::size_t length = std::fread(line, 1, kThreadNameSize, file);
    std::fclose(file);
    name.assign(line, length);
    if (!name.empty() && name.back() == '\n') name.pop_back();
    return true;
}

bool dxMayBeLastThreads(unsigned threads) {
    char state = 0;
    unsigned count = 0;
    if (!readProcess(state, count)) return hasFirstThreadEnded();
    return state == 'Z' && count == threads + 1;
}

bool dxAreLastThreads(const std::vector<std::string> &names) {
    char state = 0;
    unsigned count = 0;
    if (!readProcess(state, count) || state != 'Z') return false;
    const std::unique_ptr<DIR, int (*)(DIR *)> threads(opendir("/proc/self/task"), closedir);
    if (!threads) return false;
    while (const dirent *const entry = readdir(threads.get())) {
        const bool isThread = entry->d_name[0] != '.' && std::atoi(entry->d_name) != getpid();
        if (isThread && !isOneOf(entry->d_name, names)) return false;
    }
    return true;
}
