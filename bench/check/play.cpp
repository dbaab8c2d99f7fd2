#include "check/play.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "table.h"
#include "support/text.h"

namespace check {

namespace {

// A line that the next one replaces, on a terminal alone.
void showProgress(const std::string &text) {
    if (isatty(STDERR_FILENO)) std::cerr << "\r\x1b[K" << text << std::flush;
}

}  // namespace

Player::Player(const CheckOptions &options) : m_options(options), m_input(STDIN_FILENO) {
    bench::addLibrary(m_folder, "stock", options.stockFolder + "/libode.so.8");
    bench::addLibrary(m_folder, "ours", options.ourFolder + "/libode.so.8");
    std::filesystem::create_symlink(std::filesystem::canonical(options.observer), m_folder.file("observer.so"));
}

support::Environment Player::environment(const Engine &engine, const std::string &recordFolder, std::uint64_t dumpStep) const {
    const auto number = [](std::uint64_t value) { return value != 0 ? std::to_string(value) : ""; };
    return {{"LD_PRELOAD", bench::inFront(m_folder.file("observer.so"), "LD_PRELOAD")},
            {"LD_LIBRARY_PATH", bench::inFront(libraryFolder(engine), "LD_LIBRARY_PATH")},
            {"ODE_MT_THREADS", engine.threads},
            {"ODE_MT_SOLVER", ""},
            {kFolderVariable, recordFolder},
            {kDumpVariable, number(dumpStep)},
            {kLastVariable, number(m_options.steps)}};
}

Play Player::play(const Engine &engine, std::uint64_t dumpStep) {
    Play play{engine, m_folder.file("run-" + std::to_string(++m_plays)), {}, {}};
    std::filesystem::create_directory(play.folder);
    showProgress("run " + std::to_string(m_plays) + ": " + engine.name + " ...");
    play.run =
        runProgram({m_options.command, environment(engine, play.folder, dumpStep), m_options.limit, m_options.showOutput}, m_input);
    play.record = readRunRecord(play.folder);
    showProgress("");
    return play;
}

namespace {

bool wasCut(const Play &play, std::uint64_t lastStep) {
    const auto &worlds = play.record.worlds;
    return play.wasEnded() || (lastStep != 0 && std::any_of(worlds.begin(), worlds.end(), [&](const WorldRecord &world) {
                                   return world.lastStep() == lastStep;
                               }));
}

std::optional<std::string> differentLine(const char *what, const Play &left, const Play &right, const ProgramOutput &leftOutput,
                                         const ProgramOutput &rightOutput) {
    const auto difference = firstDifferentLine(leftOutput.text(), rightOutput.text());
    if (!difference) return std::nullopt;
    return std::string(what) + " differs from line " + std::to_string(difference->line) +
           " on: " + support::quote(difference->left) + " (" + left.engine.name + "), " + support::quote(difference->right) + " (" +
           right.engine.name + ").";
}

// ODE writes a message in pieces, between which other threads and processes write theirs.
std::optional<LineDifference> firstDifferentMessage(const Play &left, const Play &right) {
    if (makesWorldsConcurrently(left.record) || makesWorldsConcurrently(right.record)) return std::nullopt;
    return firstDifferentLine(odeMessages(left.run.errors.text()), odeMessages(right.run.errors.text()));
}

const StoredState *stateOf(const std::vector<StoredState> &states, std::uint32_t world) {
    const auto found =
        std::find_if(states.begin(), states.end(), [&](const StoredState &state) { return state.world.world == world; });
    return found != states.end() ? &*found : nullptr;
}

}  // namespace

PlayComparison comparePlays(const Play &left, const Play &right, std::uint64_t lastStep) {
    PlayComparison comparison;
    const bool areCut = left.wasEnded() || right.wasEnded() || (wasCut(left, lastStep) && wasCut(right, lastStep));
    if (areCut) comparison.ends = Ends::ignored;
    comparison.steps = compareRuns(left.record, right.record, comparison.ends);
    if (!left.wasEnded() && right.run.end == ProgramRun::End::Limit)
        comparison.ending = left.engine.name + " ends after " + bench::numberText(left.run.seconds) + " s, " + right.engine.name +
                            " had not ended after " + bench::numberText(right.run.seconds) + " s.";
    if (areCut) return comparison;
    if (left.run.status != right.run.status)
        comparison.ending =
            left.engine.name + " ends with " + left.ending() + ", " + right.engine.name + " with " + right.ending() + ".";
    if (const auto difference = firstDifferentMessage(left, right))
        comparison.messages = "Messages of ODE differ: " + support::quote(difference->left) + " (" + left.engine.name + "), " +
                              support::quote(difference->right) + " (" + right.engine.name + ").";
    comparison.output = differentLine("Standard output", left, right, left.run.output, right.run.output);
    if (!comparison.output && !comparison.messages)
        comparison.output = differentLine("Standard error", left, right, left.run.errors, right.run.errors);
    return comparison;
}

std::optional<StateDifference> findValues(const Play &left, const Play &right, std::uint64_t step) {
    const auto first = compareRuns(left.record, right.record, Ends::ignored).first;
    if (!first || first->step != step) return std::nullopt;
    const WorldName leftName = first->worlds.left->name, rightName = first->worlds.right->name;
    const auto leftStates = readStates(left.folder, leftName.process), rightStates = readStates(right.folder, rightName.process);
    const StoredState *const leftState = stateOf(leftStates, leftName.world), *const rightState =
                                                                                  stateOf(rightStates, rightName.world);
    if (leftState == nullptr || rightState == nullptr) return std::nullopt;
    return compareStates(*leftState, *rightState);
}

std::string nameOfWorld(const Play &play, const WorldName &world) {
    const std::string name = "world " + std::to_string(world.world);
    if (play.record.processes.size() == 1) return name;
    return name + " of process " + std::to_string(world.process) + " ('" + play.record.processes[world.process].program + "')";
}

}  // namespace check
