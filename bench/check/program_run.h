// One run of a program: started, given its input, listened to, and ended if it lasts too long.
//
// It ends when the process that was started ends; what that leaves running is ended then. Requires that this process has no other
// children, and has adopted orphans (orphans.h).
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "check/program_input.h"
#include "check/program_output.h"
#include "support/orphans.h"
#include "support/process.h"

namespace check {

struct RunSettings {
    std::vector<std::string> command;
    support::Environment environment;
    std::chrono::milliseconds limit{0};  // 0: none
    bool showOutput = false;             // on this process's standard error, instead of keeping it
};

struct ProgramRun {
    enum class End { Itself, Limit, Interrupt };

    End end = End::Itself;
    int status = 0;                      // as waitpid gives it
    double seconds = 0, cpuSeconds = 0;  // the latter of all processes that were waited for
    support::EndedOrphans orphans;         // what it has left running
    ProgramOutput output, errors;
};

// Throws std::runtime_error if the program cannot be started.
ProgramRun runProgram(const RunSettings &settings, ProgramInput &input);

}  // namespace check
