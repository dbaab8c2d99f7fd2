#include "support/child_run.h"

#include <cxxabi.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <stdexcept>

namespace support {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMaxText = 64u << 20;  // bytes that a process may write to a standard file

struct Files {
    MemoryFile input, output, errors;
};

// Bytes of a process that are resident now.
std::size_t residentMemory(pid_t process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/statm");
    std::size_t pages = 0, resident = 0;
    file >> pages >> resident;
    return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

[[noreturn]] void beChild(const std::function<int()> &work, const Limits &limits, const Files &files) {
    setpgid(0, 0);
    dup2(files.input.descriptor(), STDIN_FILENO);
    dup2(files.output.descriptor(), STDOUT_FILENO);
    dup2(files.errors.descriptor(), STDERR_FILENO);
    const rlimit cpu{limits.cpuSeconds, limits.cpuSeconds + 1}, core{0, 0};
    if (limits.cpuSeconds > 0) setrlimit(RLIMIT_CPU, &cpu);
    setrlimit(RLIMIT_CORE, &core);
    int code = 127;
    try {
        code = work();
    } catch (const std::exception &error) {
        std::cerr << "an exception: " << error.what() << '\n';
    } catch (abi::__forced_unwind &) {  // the thread that ends is the child's only one
        throw;
    } catch (...) {
        std::cerr << "an exception that is no std::exception\n";
    }
    std::cout.flush();
    std::fflush(nullptr);
    _exit(code);
}

// Kills the child where it passes a limit.
void watch(pid_t child, const Limits &limits, const Files &files, Ending &ending) {
    const Descriptor handle(static_cast<int>(syscall(SYS_pidfd_open, child, 0)));
    const Clock::time_point begin = Clock::now();
    for (pollfd wait{handle.number(), POLLIN, 0}; poll(&wait, 1, 20) == 0;) {
        const bool isLarge = limits.memory > 0 && residentMemory(child) > limits.memory;
        ending.ranOutOfMemory = isLarge || files.output.size() > kMaxText || files.errors.size() > kMaxText;
        ending.ranOutOfTime = limits.seconds > 0 && std::chrono::duration<double>(Clock::now() - begin).count() > limits.seconds;
        if (!ending.ranOutOfMemory && !ending.ranOutOfTime) continue;
        kill(child, SIGKILL);
        return;
    }
}

double seconds(const timeval &time) { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); }

Ending finish(pid_t child, const Limits &limits, const Files &files) {
    Ending ending;
    watch(child, limits, files, ending);
    rusage usage{};
    while (wait4(child, &ending.status, 0, &usage) < 0 && errno == EINTR) {
    }
    if (WIFSIGNALED(ending.status) && WTERMSIG(ending.status) == SIGXCPU) ending.ranOutOfTime = true;
    ending.peakMemory = static_cast<std::size_t>(usage.ru_maxrss) * 1024;
    ending.cpuSeconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    ending.output = files.output.text();
    ending.errors = files.errors.text();
    return ending;
}

}  // namespace

bool Ending::exited() const { return !ranOutOfTime && !ranOutOfMemory && WIFEXITED(status); }

int Ending::exitCode() const { return WEXITSTATUS(status); }

bool Ending::killedBy(int signal) const { return WIFSIGNALED(status) && WTERMSIG(status) == signal; }

std::string Ending::text() const {
    if (ranOutOfTime) return "time over";
    if (ranOutOfMemory) return "memory over";
    return endingOf(status);
}

Ending runProgram(const std::vector<std::string> &command, const Environment &changes, const Limits &limits) {
    const Files files;
    const pid_t child = spawn(command, changes, {-1, files.output.descriptor(), files.errors.descriptor()});
    return finish(child, limits, files);
}

Ending runFunction(const std::function<int()> &work, const Limits &limits, const std::string &input) {
    const Files files;
    files.input.write(input);
    std::cout.flush();
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("no process");
    if (child == 0) beChild(work, limits, files);
    setpgid(child, child);  // whichever of the two is first
    Ending ending = finish(child, limits, files);
    ending.leftProcesses = kill(-child, SIGKILL) == 0 && ending.exited();
    return ending;
}

Ending runInChild(const std::function<void()> &function) {
    Limits limits;
    limits.seconds = 20;
    const auto work = [&] {
        function();
        return 0;
    };
    const Ending ending = runFunction(work, limits);
    std::cout << ending.output << std::flush;
    return ending;
}

bool trueInChild(const std::function<bool()> &function) {
    const Ending ending = runInChild([&] {
        if (!function()) _exit(1);
    });
    std::cerr << ending.errors;
    return ending.exitedWith(0);
}

}  // namespace support
