#include "instruction_set.h"

// The sets that vector code is compiled for decide the places in Highway's tables.
#include "core/dxSimdTargets.h"

#include <hwy/targets.h>

#include <cstdint>
#include <stdexcept>

namespace exactness {

namespace {

// Lower bits are wider vectors.
std::vector<std::int64_t> single(std::int64_t targets) {
    std::vector<std::int64_t> all;
    for (; targets != 0; targets &= targets - 1) all.push_back(targets & -targets);
    return all;
}

// To ask Highway what the machine has counts as a choice, which is taken back.
std::vector<std::int64_t> availableTargets() {
    const std::int64_t available = hwy::SupportedTargets() & HWY_TARGETS;
    hwy::GetChosenTarget().DeInit();
    return single(available);
}

std::size_t placeInTables(std::int64_t target) {
    hwy::ChosenTarget chosen;
    chosen.Update(target);
    return chosen.GetIndex();
}

}  // namespace

std::vector<std::string> instructionSets() {
    std::vector<std::string> names;
    for (const std::int64_t target : availableTargets()) names.push_back(hwy::TargetName(target));
    return names;
}

void forceInstructionSet(const std::string &name) {
    std::string known;
    for (const std::int64_t target : availableTargets()) {
        if (name == hwy::TargetName(target)) return hwy::SetSupportedTargetsForTest(target);
        known += std::string(" ") + hwy::TargetName(target);
    }
    throw std::invalid_argument("no instruction set '" + name + "'; this machine has" + known);
}

std::string instructionSetInUse() {
    const hwy::ChosenTarget &chosen = hwy::GetChosenTarget();
    if (!chosen.IsInitialized()) return "";
    for (const std::int64_t target : single(HWY_TARGETS)) {
        if (placeInTables(target) == chosen.GetIndex()) return hwy::TargetName(target);
    }
    return "unknown";
}

}  // namespace exactness
