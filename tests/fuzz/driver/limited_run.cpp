#include "limited_run.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "process/spawn.h"

namespace fuzz_driver {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMaxText = 64u << 20;  // bytes that a process may write to a standard file

// A file in memory for a standard file of a child.
class TextFile {
public:
    explicit TextFile(const char *name) : m_descriptor(memfd_create(name, MFD_CLOEXEC)) {
        if (m_descriptor < 0) throw std::runtime_error("no file in memory");
    }
    ~TextFile() { close(m_descriptor); }
    TextFile(const TextFile &) = delete;
    TextFile &operator=(const TextFile &) = delete;

    int descriptor() const { return m_descriptor; }
    std::size_t size() const {
        struct stat file {};
        fstat(m_descriptor, &file);
        return static_cast<std::size_t>(file.st_size);
    }
    std::string text() const {
        std::string text(size(), '\0');
        const ssize_t count = pread(m_descriptor, text.data(), text.size(), 0);
        text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
        return text;
    }
    void write(const std::string &text) const {
        if (::write(m_descriptor, text.data(), text.size()) != static_cast<ssize_t>(text.size()))
            throw std::runtime_error("a file in memory takes no text");
        lseek(m_descriptor, 0, SEEK_SET);
    }

private:
    int m_descriptor;
};

// Bytes of a process that are resident now.
std::size_t residentMemory(pid_t process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/statm");
    std::size_t pages = 0, resident = 0;
    file >> pages >> resident;
    return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

[[noreturn]] void beChild(const std::function<int()> &work, const Limits &limits, const TextFile &input,
                          const TextFile &output, const TextFile &errors) {
    setpgid(0, 0);
    dup2(input.descriptor(), STDIN_FILENO);
    dup2(output.descriptor(), STDOUT_FILENO);
    dup2(errors.descriptor(), STDERR_FILENO);
    const rlimit cpu{limits.cpuSeconds, limits.cpuSeconds + 1}, core{0, 0};
    setrlimit(RLIMIT_CPU, &cpu);
    setrlimit(RLIMIT_CORE, &core);
    int code = 127;
    try {
        code = work();
    } catch (const std::exception &error) {
        std::cerr << "an exception: " << error.what() << '\n';
    } catch (...) {
        std::cerr << "an exception that is no std::exception\n";
    }
    std::cout.flush();
    std::fflush(nullptr);
    _exit(code);
}

}  // namespace

bool Ending::exited() const { return !ranOutOfTime && !ranOutOfMemory && WIFEXITED(status); }

int Ending::exitCode() const { return WEXITSTATUS(status); }

std::string Ending::text() const {
    if (ranOutOfTime) return "time over";
    if (ranOutOfMemory) return "memory over";
    return process::endingOf(status);
}

Ending runLimited(const std::function<int()> &work, const Limits &limits, const std::string &input) {
    const TextFile in("input"), out("output"), err("errors");
    in.write(input);
    std::cout.flush();
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("no process");
    if (child == 0) beChild(work, limits, in, out, err);
    setpgid(child, child);  // whichever of the two is first

    Ending ending;
    const int handle = static_cast<int>(syscall(SYS_pidfd_open, child, 0));
    const Clock::time_point begin = Clock::now();
    for (pollfd wait{handle, POLLIN, 0}; poll(&wait, 1, 20) == 0;) {
        ending.ranOutOfMemory =
            residentMemory(child) > limits.memory || out.size() > kMaxText || err.size() > kMaxText;
        ending.ranOutOfTime = std::chrono::duration<double>(Clock::now() - begin).count() > limits.seconds;
        if (ending.ranOutOfMemory || ending.ranOutOfTime) break;
    }
    close(handle);
    if (ending.ranOutOfMemory || ending.ranOutOfTime) kill(child, SIGKILL);
    rusage usage{};
    wait4(child, &ending.status, 0, &usage);
    ending.leftProcesses = kill(-child, SIGKILL) == 0 && ending.exited();
    if (WIFSIGNALED(ending.status) && WTERMSIG(ending.status) == SIGXCPU) ending.ranOutOfTime = true;
    ending.peakMemory = static_cast<std::size_t>(usage.ru_maxrss) * 1024;
    ending.cpuSeconds = static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
                        1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
    ending.output = out.text();
    ending.errors = err.text();
    return ending;
}

void setSanitizerOptions() {
    const std::string code = "exitcode=" + std::to_string(kSanitizerExitCode);
    for (const char *const variable : {"ASAN_OPTIONS", "UBSAN_OPTIONS", "LSAN_OPTIONS"}) {
        const char *const set = getenv(variable);
        const std::string more =
            std::string(variable) == "ASAN_OPTIONS" ? ":detect_stack_use_after_return=0" : "";
        setenv(variable, ((set && *set ? std::string(set) + ":" : "") + code + more).c_str(), 1);
    }
}

}  // namespace fuzz_driver
