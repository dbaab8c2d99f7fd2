// A process of its own for what may crash, hang or take all memory.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace fuzz_driver {

struct Limits {
    double seconds = 20;           // by the clock, after which the process is ended
    unsigned cpuSeconds = 10;      // of all its threads
    std::size_t memory = 1 << 30;  // bytes that are resident at one time
};

struct Ending {
    int status = 0;  // as waitpid returns it
    bool ranOutOfTime = false, ranOutOfMemory = false, leftProcesses = false;
    std::size_t peakMemory = 0;  // bytes, if the system reports them
    double cpuSeconds = 0;
    std::string output, errors;  // of the two standard files

    bool exited() const;
    int exitCode() const;  // Requires exited().
    // "exit code 2", "signal 11 (Segmentation fault)", "time over", "memory over"
    std::string text() const;
};

// Calls `work` in a child, with standard input from `input`, and waits for its end. `work` may end by
// executing a program; when it returns, the child exits with its result.
Ending runLimited(const std::function<int()> &work, const Limits &limits, const std::string &input = {});

// Exit code of a process that a sanitizer has ended, if its options are those of sanitizerOptions.
constexpr int kSanitizerExitCode = 99;

// Makes sanitizers of programs that are executed from now on end them with kSanitizerExitCode.
void setSanitizerOptions();

}  // namespace fuzz_driver
