#include "check/checker.h"

#include <sys/wait.h>

#include <algorithm>

#include "check/play.h"
#include "check/unseen.h"
#include "platform.h"
#include "table.h"
#include "support/process.h"

namespace check {

namespace {

using Verdict = CheckResult::Verdict;

std::string counted(std::uint64_t number, const char *thing) {
    return std::to_string(number) + ' ' + thing + (number == 1 ? "" : "s");
}

// Of further plays on each library, where something differs.
constexpr int kRounds = 4;

Engine ours(const std::string &threads) {
    return {"ODE_MT, " + (threads == "auto" ? "all cores" : threads + (threads == "1" ? " thread" : " threads")), threads};
}

// What a difference of steps looks like from outside.
std::string textOf(const FirstDifference &first, const Play &left, const Play &right) {
    const WorldRecord *const leftWorld = first.worlds.left, *const rightWorld = first.worlds.right;
    const std::string world = leftWorld != nullptr ? nameOfWorld(left, leftWorld->name) : nameOfWorld(right, rightWorld->name);
    if (leftWorld == nullptr || rightWorld == nullptr)
        return "only " + (leftWorld != nullptr ? left : right).engine.name + " steps " + world;
    if (first.kind == FirstDifference::Kind::State)
        return world + " differs at step " + std::to_string(first.step) + (first.step == 1 ? ", its first" : " for the first time");
    return world + " makes " + counted(leftWorld->lastStep(), "step") + " on " + left.engine.name + ", " +
           std::to_string(rightWorld->lastStep()) + " on " + right.engine.name;
}

// Where a difference of states is seen first; empty: it was not seen again.
std::string placeOf(const std::optional<StateDifference> &values) {
    if (!values) return "";
    const ValueDifference &value = values->values.front();
    return ", in " + value.field + (value.body ? " of body " + std::to_string(*value.body) : "");
}

class Checker {
public:
    explicit Checker(const CheckOptions &options) : m_options(options), m_player(options) {}

    CheckResult check() {
        compareReleases();
        compareAll();
        tellEndings();
        return m_result;
    }

private:
    void compareReleases() {
        if (bench::areOtherReleases(m_options.stockRelease, m_options.ourRelease))
            remark("libode8 here is ODE " + m_options.stockRelease + ", ours is made of " + m_options.ourRelease +
                   ": results may differ, since the releases do (docs/tools.md).");
    }

    void compareAll() {
        const Play stock = play({"libode8", ""});
        addEngine(stock, "");
        if (m_wasInterrupted) return notCompared("Interrupted during the first run: there is nothing to compare it with.");
        if (const auto reason = whyNoSteps(stock, m_options.command[0])) return notCompared(*reason);
        if (const auto reason = whyWrongLibrary(stock)) return notCompared(*reason);
        for (const std::string &threads : m_options.threads) {
            const Play other = play(ours(threads));
            if (const auto reason = whyWrongLibrary(other)) return notCompared(*reason);
            compare(stock, other);
            if (m_isOver || m_wasInterrupted) return;
        }
        conclude(stock);
    }

    Play play(const Engine &engine, std::uint64_t dumpStep = 0) {
        Play play = m_player.play(engine, dumpStep);
        if (play.run.end == ProgramRun::End::Interrupt)
            m_wasInterrupted = true;
        else
            m_ends.push_back({engine.name, play.run.status, play.run.end == ProgramRun::End::Limit, play.run.errors.lastLines(3)});
        if (!play.wasEnded() && play.run.orphans.wereThere) m_hasLeftProcesses = true;
        if (play.run.orphans.areLeft) m_couldNotEndAll = true;
        return play;
    }

    void addEngine(const Play &play, const std::string &result) {
        const RunRecord &record = play.record;
        m_result.engines.push_back({play.engine.name, record.processes.empty() ? "" : record.processes[0].library,
                                    play.engine.isOurs() ? m_options.ourRelease : m_options.stockRelease, play.ending(),
                                    play.run.seconds, play.run.cpuSeconds, record.stepSeconds(), record.observerSeconds(),
                                    record.steps(), result});
    }

    void notCompared(const std::string &sentence) {
        m_result.verdict = Verdict::NotCompared;
        m_result.sentence = sentence;
        m_isOver = true;
    }

    void remark(const std::optional<std::string> &sentence) {
        if (sentence) m_result.remarks.push_back(*sentence);
    }

    // The first number of threads with a difference is looked into.
    void compare(const Play &stock, const Play &other) {
        const PlayComparison comparison = comparePlays(stock, other, m_options.steps);
        addEngine(other, resultOf(comparison));
        const std::uint64_t equalSteps = comparison.steps.equalSteps;
        if (m_result.engines.size() == 2 || equalSteps < m_result.steps) m_result.steps = equalSteps;
        m_result.worlds = comparison.steps.worlds;
        m_result.bodies = comparison.steps.bodies;
        if (m_result.verdict == Verdict::Different) return;
        if (!comparison.isEqual()) return investigate(stock, other, comparison);
        remark(comparison.output);
        if (m_wasInterrupted)
            notCompared("Interrupted: equal for the " + counted(equalSteps, "step") + " that both libode8 and " +
                        other.engine.name + " had made by then.");
    }

    static std::string resultOf(const PlayComparison &comparison) {
        const auto &first = comparison.steps.first;
        if (first && first->kind == FirstDifference::Kind::State) return "differs at step " + std::to_string(first->step);
        if (first) return "other steps";
        return comparison.ending ? "ends differently" : comparison.messages ? "other messages" : "equal";
    }

    // Whether the program differs from itself, or else in which values from libode8.
    void investigate(const Play &stock, const Play &other, const PlayComparison &comparison) {
        const auto &first = comparison.steps.first;
        const bool hasStates = first && first->kind == FirstDifference::Kind::State;
        const std::uint64_t step = hasStates ? first->step : 0;
        std::optional<StateDifference> values;
        std::optional<std::string> otherWay;  // in which a further play has differed
        int equal = 0, rounds = 0;
        while (rounds < kRounds && !m_wasInterrupted) {
            const Play again = play({"libode8 again", ""}, step);
            if (m_wasInterrupted) break;
            const PlayComparison itself = comparePlays(stock, again, m_options.steps);
            if (!itself.isEqual()) return notReproducible(stock, again, itself, hasStates ? 0 : comparison.steps.equalSteps);
            const Play repeated = play({other.engine.name + " again", other.engine.threads}, step);
            if (m_wasInterrupted) break;
            ++rounds;
            if (comparePlays(again, repeated, m_options.steps).isEqual()) ++equal;
            if (!hasStates) continue;
            auto found = findValues(again, repeated, step);
            if (!found && !otherWay) otherWay = otherStep(again, repeated);
            if (!values) values = std::move(found);
        }
        if (equal > 0 && hasOwnSchedule(stock, other)) return undecided(stock, other, comparison, equal, rounds);
        if (equal > 0)
            remark(sometimesText(other, equal, rounds) + ": what differs depends on time or chance.");
        else if (otherWay)
            remark("Another run on " + other.engine.name + " did not differ in the same way" + *otherWay +
                   ": what differs depends on time or chance.");
        differ(stock, other, comparison, values);
    }

    // Whether time decides which thread or process makes which world.
    static bool hasOwnSchedule(const Play &stock, const Play &other) {
        return makesWorldsConcurrently(stock.record) || makesWorldsConcurrently(other.record);
    }

    static std::string sometimesText(const Play &other, int equal, int rounds) {
        return counted(static_cast<std::uint64_t>(rounds + 1 - equal), "run") + " of " + std::to_string(rounds + 1) + " on " + other.engine.name +
               " differed, and none of " + std::to_string(rounds + 1) + " on libode8";
    }

    // A difference that some runs on ODE_MT have, of a program whose own threads or processes may be the reason.
    void undecided(const Play &stock, const Play &other, const PlayComparison &comparison, int equal, int rounds) {
        const auto &first = comparison.steps.first;
        notCompared("Not decided: " + sometimesText(other, equal, rounds) +
                    ". Several threads or processes of the program make worlds, so its own order of events may be the reason. The difference: " +
                    (first               ? textOf(*first, stock, other) + '.'
                     : comparison.ending ? *comparison.ending
                                         : *comparison.messages));
        if (first) setFinding(other.engine.name, *first, stock, other, std::nullopt);
    }

    std::string otherStep(const Play &left, const Play &right) const {
        const auto first = comparePlays(left, right, m_options.steps).steps.first;
        return first ? ", but at step " + std::to_string(first->step) : "";
    }

    void differ(const Play &stock, const Play &other, const PlayComparison &comparison,
                const std::optional<StateDifference> &values) {
        m_result.verdict = Verdict::Different;
        const auto &first = comparison.steps.first;
        m_result.sentence = "Different on " + other.engine.name + ": " +
                            (first               ? textOf(*first, stock, other) + placeOf(values) + '.'
                             : comparison.ending ? *comparison.ending
                                                 : *comparison.messages) +
                            " Equal before: " + counted(comparison.steps.equalSteps, "step") + '.';
        if (first || comparison.ending) remark(comparison.messages);
        const std::string words = other.run.errors.lastLines(3);
        if (comparison.ending && !WIFSIGNALED(other.run.status) && !words.empty()) remark(wordsOf(other.engine.name, words));
        if (!comparison.ending) remark(comparison.output);
        if (first && areEqualInAnotherOrder(stock.record, other.record, comparison.ends))
            remark("Each world does what one of another number does on the other library: either they have exchanged their states, or the "
                   "program makes them in an order that depends on time or chance.");
        if (first) setFinding(other.engine.name, *first, stock, other, values);
    }

    void setFinding(const std::string &engine, const FirstDifference &first, const Play &left, const Play &right,
                    const std::optional<StateDifference> &values) {
        const bool isLeft = first.worlds.left != nullptr;
        const WorldRecord *const world = isLeft ? first.worlds.left : first.worlds.right;
        m_result.finding = Finding{engine, first.step, nameOfWorld(isLeft ? left : right, world->name), values};
    }

    // Two plays that both keep the states behind the step say in which values. `equalSteps`: which ODE_MT has made as well, and no
    // other.
    void notReproducible(const Play &stock, const Play &again, const PlayComparison &itself, std::uint64_t equalSteps) {
        const auto &first = itself.steps.first;
        notCompared("The program itself is not reproducible: two runs on libode8 " +
                    (first           ? "differ: " + textOf(*first, stock, again)
                     : itself.ending ? "end in different ways: " + *itself.ending
                                     : "differ: " + *itself.messages));
        if (!first || first->kind != FirstDifference::Kind::State) {
            if (first) m_result.sentence += '.';
            if (equalSteps > 0)
                remark("The states are the same on ODE_MT as far as its run and the first one go: " + counted(equalSteps, "step") +
                       '.');
            return;
        }
        std::optional<StateDifference> values;
        const Play left = play({"libode8, third run", ""}, first->step);
        if (!m_wasInterrupted) values = findValues(left, play({"libode8, fourth run", ""}, first->step), first->step);
        m_result.sentence += placeOf(values) + '.';
        remark(
            "Nothing can be said about ODE_MT then. Usual reasons: step sizes measured with a clock, random numbers without a "
            "seed.");
        setFinding("libode8", *first, stock, again, values);
    }

    void conclude(const Play &stock) {
        if (m_result.verdict == Verdict::Different) return;
        m_result.verdict = Verdict::Equal;
        m_result.sentence = "Equal for " + counted(m_result.steps, "step") + ": the states of " +
                            (m_result.bodies == 1 ? "1 body" : std::to_string(m_result.bodies) + " bodies") + " in " +
                            counted(m_result.worlds, "world") + " are the same in every bit.";
        if (stock.wasEnded())
            remark("Runs were ended after " + bench::numberText(1e-3 * static_cast<double>(m_options.limit.count())) +
                   " s: steps that both had made were compared.");
        else if (stock.run.status != 0 && std::all_of(m_ends.begin(), m_ends.end(), [&](const End &end) { return end == m_ends[0]; }))
            remark("The program ends with " + stock.ending() + ", on both libraries.");
    }

    // How a play has ended.
    struct End {
        std::string name;
        int status;
        bool isLimit;  // --seconds were over
        std::string words;

        bool operator==(const End &other) const { return isLimit == other.isLimit && (isLimit || status == other.status); }
        bool isFault() const { return !isLimit && WIFSIGNALED(status); }
    };

    static std::string wordsOf(const std::string &name, const std::string &words) { return name + " says at the end: " + words; }

    // Of a program of which nothing was seen.
    bool isSaid(const End &end) const { return m_result.sentence.find("ended with " + support::endingOf(end.status)) != std::string::npos; }

    std::string textOfEnds() const {
        std::string text;
        for (auto at = m_ends.begin(); at != m_ends.end(); ++at) {
            const End &end = *at;
            if (std::any_of(m_ends.begin(), at, [&](const End &earlier) { return earlier.name == end.name && earlier == end; })) continue;
            text += (text.empty() ? "" : ", ") + end.name + (text.empty() ? " ends with " : " with ") + support::endingOf(end.status) +
                    (end.isLimit ? " after --seconds" : "");
        }
        return text + '.';
    }

    // Of all plays, where one has ended otherwise than another, or by a signal.
    void tellEndings() {
        if (m_couldNotEndAll) remark("Some processes that the program has left running could not be ended.");
        const bool isDifferent = std::any_of(m_ends.begin(), m_ends.end(), [&](const End &end) { return !(end == m_ends[0]); });
        const bool hasFault = std::any_of(m_ends.begin(), m_ends.end(), [](const End &end) { return end.isFault(); });
        if (isDifferent || (hasFault && m_result.verdict != Verdict::Equal && !isSaid(m_ends[0]))) remark(textOfEnds());
        std::vector<std::string> told;
        for (const End &end : m_ends)
            if (isDifferent && end.isFault() && !end.words.empty() && std::find(told.begin(), told.end(), end.words) == told.end()) {
                remark(wordsOf(end.name, end.words));
                told.push_back(end.words);
            }
        if (m_hasLeftProcesses && m_result.verdict != Verdict::Equal)
            remark("The program leaves processes running when it ends itself, which are ended then: how far they get depends on time.");
    }

    const CheckOptions &m_options;
    Player m_player;
    CheckResult m_result;
    std::vector<End> m_ends;  // of plays that were not interrupted
    bool m_isOver = false, m_wasInterrupted = false, m_hasLeftProcesses = false, m_couldNotEndAll = false;
};

}  // namespace

CheckResult check(const CheckOptions &options) { return Checker(options).check(); }

}  // namespace check
