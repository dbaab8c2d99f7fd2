// A program or a function in a process of its own, run to its end: what it wrote, how it ended, what it took. It may crash, hang or take all
// memory; that is heard here.
//
// Threading: a function runs in a fork of this process, with the thread alone that forks.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "support/process.h"

namespace support {

struct Limits {
    double seconds = 0;       // by the clock, after which the process is killed; 0: no limit
    unsigned cpuSeconds = 0;  // of all its threads, after which the system kills it; 0: no limit
    std::size_t memory = 0;   // bytes that are resident at one time; 0: no limit
};

struct Ending {
    int status = 0;  // as waitpid returns it
    bool ranOutOfTime = false, ranOutOfMemory = false, leftProcesses = false;
    std::size_t peakMemory = 0;  // bytes, if the system reports them
    double cpuSeconds = 0;
    std::string output, errors;  // of the two standard files, each of which is a file for the process

    bool exited() const;  // by itself
    int exitCode() const;  // Requires exited().
    bool exitedWith(int code) const { return exited() && exitCode() == code; }
    bool killedBy(int signal) const;
    // "exit code 2", "signal 11 (Segmentation fault)", "time over", "memory over"
    std::string text() const;
};

// Runs a program with `changes` on top of this process's environment. Throws std::runtime_error, which names the program, if it cannot be
// started.
Ending runProgram(const std::vector<std::string> &command, const Environment &changes, const Limits &limits = {});

// Calls `work` in a child, with standard input from `input`. `work` may end by executing a program; when it returns, the child exits with
// its result, without what was registered with atexit. What the process leaves running is killed.
Ending runFunction(const std::function<int()> &work, const Limits &limits, const std::string &input = {});

// Calls a function in a child, for 20 s at most, and passes on its standard output. It exits with 0 if the function returns.
Ending runInChild(const std::function<void()> &function);

// Returns whether the function returned true in a child, as runInChild calls it, and passes on its standard error.
bool trueInChild(const std::function<bool()> &function);

}  // namespace support
