// Whole frames give the same bits with vectors of every width and every number of threads. The exactness suite
// compares them with libode8, cyclically; this test has all combinations.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <cstring>

#include "ChainWorld.h"
#include "instruction_sets.h"
#include "OdeSession.h"
#include "PackedWorld.h"

namespace {

constexpr int kThreads[] = {0, 1, 2, 3, 8};
constexpr int kFrames = 12;

std::vector<dReal> packed(int columns, int rows, int layers, dWorldStepFunction *stepper) {
    PackedWorld world(columns, rows, layers, stepper);
    dRandSetSeed(5);
    for (int frame = 0; frame < kFrames; ++frame) world.frame();
    return world.state();
}

std::vector<dReal> chains(unsigned count, unsigned links) {
    ChainWorld world(count, links, dWorldStep);
    world.step(kFrames);
    return world.state();
}

bool areSameBits(const std::vector<dReal> &a, const std::vector<dReal> &b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(dReal)) == 0;
}

// Runs `state` with vector code that has this set to choose from alone, and looks whether it chose.
template <class State>
std::vector<dReal> runChoosing(std::int64_t set, const State &state) {
    hwy::GetChosenTarget().DeInit();
    const std::vector<dReal> result = state();
    EXPECT_TRUE(hwy::GetChosenTarget().IsInitialized()) << "no vector code has run";
    hwy::ChosenTarget expected;
    expected.Update(set);
    EXPECT_EQ(hwy::GetChosenTarget().GetIndex(), expected.GetIndex());
    return result;
}

template <class State>
void expectSameBits(const State &state) {
    const OdeSession session;
    const std::vector<dReal> expected = state();
    for (const std::int64_t set : instructionSets()) {
        onInstructionSet(set, [&] {
            for (const int threads : kThreads) {
                OdeSession::use(threads, "lcp");
                EXPECT_TRUE(areSameBits(runChoosing(set, state), expected)) << threads << " threads";
            }
        });
        OdeSession::use(0, "lcp");
    }
}

// One island that several workers step together.
TEST(VectorWidth, QuickStepOfAHeap) {
    expectSameBits([] { return packed(8, 8, 4, dWorldQuickStep); });
}

TEST(VectorWidth, ExactStepOfAWall) {
    expectSameBits([] { return packed(4, 1, 3, dWorldStep); });
}

TEST(VectorWidth, ExactStepOfSmallIslands) {
    expectSameBits([] { return chains(12, 5); });
}

// More rows than those from which the exact step's matrices are kept by their elements.
TEST(VectorWidth, ExactStepOfLongChains) {
    expectSameBits([] { return chains(3, 90); });
}

}  // namespace
