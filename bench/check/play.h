// A program played on one of the two libraries, and two plays compared in all that counts and in what is told besides.
#pragma once

#include <optional>
#include <string>

#include "check/check_options.h"
#include "check/first_difference.h"
#include "check/program_run.h"
#include "check/run_record.h"
#include "check/state_difference.h"
#include "library_folders.h"
#include "support/process.h"
#include "support/temporary_folder.h"

namespace check {

struct Engine {
    std::string name;     // "libode8", "ODE_MT, 2 threads"
    std::string threads;  // of ODE_MT; empty: Debian's libode8

    bool isOurs() const { return !threads.empty(); }
};

// A run of the program on one library, under the observer, and what was recorded of it.
struct Play {
    Engine engine;
    std::string folder;  // of the record
    ProgramRun run;
    RunRecord record;

    std::string ending() const { return support::endingOf(run.status); }
    bool wasEnded() const { return run.end != ProgramRun::End::Itself; }
};

class Player {
public:
    explicit Player(const CheckOptions &options);

    // `dumpStep`: the step behind which states are kept; 0: none. Throws std::runtime_error if the program cannot be started.
    Play play(const Engine &engine, std::uint64_t dumpStep = 0);

private:
    support::Environment environment(const Engine &engine, const std::string &recordFolder, std::uint64_t dumpStep) const;
    std::string libraryFolder(const Engine &engine) const { return m_folder.file(engine.isOurs() ? "ours" : "stock"); }

    const CheckOptions &m_options;
    support::TemporaryFolder m_folder{"odemt_check"};
    ProgramInput m_input;
    int m_plays = 0;
};

// Two plays of a program, compared in all that counts, and in what is told besides.
struct PlayComparison {
    Comparison steps;
    Ends ends = Ends::compared;           // which were compared
    std::optional<std::string> ending;    // how they end differently: "killed by …", in words
    std::optional<std::string> messages;  // of ODE's own that differ
    std::optional<std::string> output;    // what else they print differently; no difference of results

    bool isEqual() const { return !steps.first && !ending && !messages; }
};

// `lastStep`: the step behind which plays were ended, or 0.
PlayComparison comparePlays(const Play &left, const Play &right, std::uint64_t lastStep);

// The values that differ behind the step of a difference, of plays that kept its states. Empty: the plays do not differ there now.
std::optional<StateDifference> findValues(const Play &left, const Play &right, std::uint64_t step);

// "world 0", "world 0 of process 1 ('/usr/bin/x')".
std::string nameOfWorld(const Play &play, const WorldName &world);

}  // namespace check
