// Plays of a program: runs of it on one library, under the observer, with what was recorded of each.
#pragma once

#include "check/check_options.h"
#include "check/program_run.h"
#include "check/run_record.h"
#include "library_folders.h"
#include "support/process.h"

namespace check {

struct Engine {
    std::string name;     // "libode8", "ODE_MT, 2 threads"
    std::string threads;  // of ODE_MT; empty: Debian's libode8

    bool isOurs() const { return !threads.empty(); }
};

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

}  // namespace check
