#include "check/first_difference.h"

#include <algorithm>
#include <map>
#include <set>

namespace check {

namespace {

// Number of steps for which two worlds agree.
std::uint64_t agreement(const WorldRecord &left, const WorldRecord &right) {
    if (left.firstStep != right.firstStep) return 0;
    const auto ends = std::mismatch(left.hashes.begin(), left.hashes.end(), right.hashes.begin(), right.hashes.end());
    return static_cast<std::uint64_t>(ends.first - left.hashes.begin());
}

bool areSame(const WorldRecord &left, const WorldRecord &right) {
    return left.firstStep == right.firstStep && left.hashes == right.hashes;
}

// The worlds of each process of a run, by the process's number.
using Processes = std::map<std::uint32_t, std::vector<const WorldRecord *>>;

Processes processesOf(const RunRecord &run) {
    Processes processes;
    for (const WorldRecord &world : run.worlds) processes[world.name.process].push_back(&world);
    return processes;
}

// Whether two processes make the same worlds, in whatever order.
bool makeTheSame(const std::vector<const WorldRecord *> &left, const std::vector<const WorldRecord *> &right) {
    return std::is_permutation(left.begin(), left.end(), right.begin(), right.end(),
                               [](const WorldRecord *a, const WorldRecord *b) { return areSame(*a, *b); });
}

// Processes that share tasks may make a world in another process each time, where it has another number: several processes of
// a run that make what no process of the other run makes.
struct SharingProcesses {
    std::set<std::uint32_t> left, right;

    SharingProcesses(const RunRecord &leftRun, const RunRecord &rightRun) {
        Processes ofLeft = processesOf(leftRun), ofRight = processesOf(rightRun);
        for (auto process = ofLeft.begin(); process != ofLeft.end();) {
            const auto same =
                std::find_if(ofRight.begin(), ofRight.end(), [&](const auto &other) { return makeTheSame(process->second, other.second); });
            if (same == ofRight.end()) {
                ++process;
                continue;
            }
            ofRight.erase(same);
            process = ofLeft.erase(process);
        }
        if (std::max(ofLeft.size(), ofRight.size()) < 2) return;
        for (const auto &[process, worlds] : ofLeft) left.insert(process);
        for (const auto &[process, worlds] : ofRight) right.insert(process);
    }
};

// Of the worlds of both runs, those that have no partner yet.
class Pairing {
public:
    Pairing(const RunRecord &left, const RunRecord &right) : m_sharing(left, right) {
        for (const WorldRecord &world : left.worlds) m_left.push_back(&world);
        for (const WorldRecord &world : right.worlds) m_right.push_back(&world);
    }

    // Of several that are fit the one of the same number is taken.
    template <class Fits>
    void pairThat(Fits fits) {
        for (auto &left : m_left) {
            const WorldRecord **best = nullptr;
            for (auto &right : m_right) {
                if (right == nullptr || !mayBePartners(*left, *right) || !fits(*left, *right)) continue;
                if (best == nullptr || left->name == right->name) best = &right;
            }
            if (best != nullptr) take(left, *best);
        }
        forgetTaken();
    }

    void pairByAgreement() {
        for (auto &left : m_left) {
            const WorldRecord **best = nullptr;
            std::uint64_t most = 0;
            for (auto &right : m_right) {
                if (right == nullptr || !mayBePartners(*left, *right)) continue;
                const std::uint64_t steps = agreement(*left, *right);
                if (best == nullptr || steps > most) best = &right, most = steps;
            }
            if (best != nullptr) take(left, *best);
        }
        forgetTaken();
    }

    std::vector<WorldPair> finish() {
        for (const WorldRecord *left : m_left) m_pairs.push_back({left, nullptr});
        for (const WorldRecord *right : m_right) m_pairs.push_back({nullptr, right});
        return std::move(m_pairs);
    }

private:
    // Worlds that are numbered in both runs have one partner in each process at most, whatever they do.
    bool mayBePartners(const WorldRecord &left, const WorldRecord &right) const {
        const bool areNumbered = left.isNumbered && m_sharing.left.count(left.name.process) == 0 && right.isNumbered &&
                                 m_sharing.right.count(right.name.process) == 0;
        return !areNumbered || left.name.world == right.name.world;
    }

    void take(const WorldRecord *&left, const WorldRecord *&right) {
        m_pairs.push_back({left, right});
        left = right = nullptr;
    }

    void forgetTaken() {
        for (auto *worlds : {&m_left, &m_right}) worlds->erase(std::remove(worlds->begin(), worlds->end(), nullptr), worlds->end());
    }

    SharingProcesses m_sharing;
    std::vector<const WorldRecord *> m_left, m_right;
    std::vector<WorldPair> m_pairs;
};

std::optional<FirstDifference> differenceOf(const WorldPair &pair, std::uint64_t equalSteps, Ends ends) {
    if (pair.left == nullptr) return FirstDifference{FirstDifference::Kind::LeftEnd, pair.right->firstStep, pair};
    if (pair.right == nullptr) return FirstDifference{FirstDifference::Kind::RightEnd, pair.left->firstStep, pair};
    const std::uint64_t step = std::min(pair.left->firstStep, pair.right->firstStep) + equalSteps;
    const bool hasLeft = step <= pair.left->lastStep(), hasRight = step <= pair.right->lastStep();
    if (hasLeft && hasRight) return FirstDifference{FirstDifference::Kind::State, step, pair};
    if (ends == Ends::ignored || hasLeft == hasRight) return std::nullopt;
    return FirstDifference{hasLeft ? FirstDifference::Kind::RightEnd : FirstDifference::Kind::LeftEnd, step, pair};
}

}  // namespace

std::vector<WorldPair> pairWorlds(const RunRecord &left, const RunRecord &right) {
    Pairing pairing(left, right);
    pairing.pairThat(areSame);
    pairing.pairThat([](const WorldRecord &a, const WorldRecord &b) { return a.name == b.name && agreement(a, b) > 0; });
    pairing.pairByAgreement();
    return pairing.finish();
}

bool areEqualInAnotherOrder(RunRecord left, RunRecord right, Ends ends) {
    if (left.worlds.size() != right.worlds.size()) return false;  // of runs that were ended, one that only one has made is left out
    for (RunRecord *const run : {&left, &right})
        for (WorldRecord &world : run->worlds) world.isNumbered = false;
    return !compareRuns(left, right, ends).first;
}

Comparison compareRuns(const RunRecord &left, const RunRecord &right, Ends ends) {
    Comparison comparison;
    for (const WorldPair &pair : pairWorlds(left, right)) {
        const bool isPair = pair.left != nullptr && pair.right != nullptr;
        if (!isPair && ends == Ends::ignored) continue;
        const std::uint64_t equalSteps = isPair ? agreement(*pair.left, *pair.right) : 0;
        comparison.equalSteps += equalSteps;
        comparison.worlds += 1;
        comparison.bodies += (pair.left != nullptr ? pair.left : pair.right)->mostBodies;
        const auto difference = differenceOf(pair, equalSteps, ends);
        if (difference && (!comparison.first || difference->step < comparison.first->step)) comparison.first = difference;
    }
    return comparison;
}

}  // namespace check
