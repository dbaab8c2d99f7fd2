#include "check/comparison.h"

#include <algorithm>

#include "support/text.h"
#include "number_text.h"

namespace check {

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
