// One run of a program: started, given its input, listened to, and ended if it lasts too long.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "check/program_output.h"
#include "support/orphans.h"
#include "support/process.h"

namespace check {

// Standard input for a program that runs several times: what its first run is given is kept, and given to the others again.
//
// A terminal is not handed on: nobody types the same twice. Programs find its end at once then.
class ProgramInput {
public:
    explicit ProgramInput(int source);

    bool isEmpty() const { return m_source < 0; }
    // To be polled for reading during the first run; -1: there is no more.
    int source() const { return m_isEnded ? -1 : m_source; }
    // Reads some more of the source.
    void readSource();

    // All that has been read yet.
    const std::string &text() const { return m_text; }
    bool isEnded() const { return m_isEnded; }
    // Behind the first run.
    void end() { m_isEnded = true; }

private:
    int m_source;  // -1: none
    bool m_isEnded;
    std::string m_text;
};

// A run ends when the process that was started ends; what that leaves running is ended then. Requires that this process has no other
// children, and has adopted orphans (orphans.h).
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
    support::EndedOrphans orphans;       // what it has left running
    ProgramOutput output, errors;
};

// Throws std::runtime_error if the program cannot be started.
ProgramRun runProgram(const RunSettings &settings, ProgramInput &input);

}  // namespace check
