// QuickStep's sweep gives the bits of taking the rows one by one, for every instruction set of this machine.
#include "dynamics/quick_step/sor/dxSorSweep.h"

#include <gtest/gtest.h>

#include "instruction_sets.h"
#include "random_sor_island.h"

namespace {

class SorSweep : public testing::TestWithParam<bool> {};  // with extreme numbers?

TEST_P(SorSweep, IsThatOfTakingRowsOneByOne) {
    for (const std::int64_t set : instructionSets()) {
        onInstructionSet(set, [] {
            for (const Size size : kSizes) {
                RandomIsland ours(size.joints, size.bodies, 7 + size.joints, GetParam());
                RandomIsland reference(size.joints, size.bodies, 7 + size.joints, GetParam());
                for (int sweep = 0; sweep < 6; ++sweep) {
                    ours.shuffle();
                    reference.shuffle();
                    dxSorSweep(ours.problem(), ours.order.data(), sweep % 2 != 0);
                    sweepOneByOne(reference);
                    ASSERT_TRUE(sameState(ours, reference)) << size.joints << " joints";
                }
                if (!GetParam()) { ASSERT_TRUE(mostlyFinite(ours.columns())); }
            }
        });
    }
}

INSTANTIATE_TEST_SUITE_P(Numbers, SorSweep, testing::Bool(),
                         [](const auto &info) { return info.param ? "extreme" : "ordinary"; });

}  // namespace
