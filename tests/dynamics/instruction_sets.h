// Vector code forced to one instruction set after the other.
#pragma once

#include "core/dxSimdTargets.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cstdint>
#include <vector>

// What this machine has of the instruction sets that vector code is compiled for.
inline std::vector<std::int64_t> instructionSets() {
    std::vector<std::int64_t> sets;
    std::int64_t rest = hwy::SupportedTargets() & ~std::int64_t(HWY_DISABLED_TARGETS);
    for (; rest != 0; rest &= rest - 1) sets.push_back(rest & -rest);
    return sets;
}

// Runs `body` with the vector code of one instruction set.
template <class Body>
void onInstructionSet(std::int64_t set, const Body &body) {
    hwy::SetSupportedTargetsForTest(set);
    hwy::GetChosenTarget().Update(set);
    SCOPED_TRACE(hwy::TargetName(set));
    body();
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().DeInit();
}

// With that of each.
template <class Test>
void onAllInstructionSets(const Test &test) {
    for (const std::int64_t set : instructionSets()) onInstructionSet(set, test);
}
