// A search by clusters takes no memory once it has run: calls of malloc and its relatives are counted.
//
// A program of its own, because it puts its functions in the place of the C library's.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <vector>

#include "ClusteredSpace.h"
#include "CrossoverPasses.h"
#include "collision/spaces/dxOrderedSpace.h"
#include "sanitizers.h"

namespace {

bool g_counting = false;
unsigned g_allocations = 0;

}  // namespace

#if !defined(ODE_MT_ADDRESS_SANITIZER) && !defined(ODE_MT_THREAD_SANITIZER)
extern "C" {
void *__libc_malloc(std::size_t);
void *__libc_calloc(std::size_t, std::size_t);
void *__libc_realloc(void *, std::size_t);

void *malloc(std::size_t size) {
    g_allocations += g_counting;
    return __libc_malloc(size);
}
void *calloc(std::size_t number, std::size_t size) {
    g_allocations += g_counting;
    return __libc_calloc(number, size);
}
void *realloc(void *block, std::size_t size) {
    g_allocations += g_counting;
    return __libc_realloc(block, size);
}
}
#endif

namespace {

class BroadphaseAllocation : public testing::TestWithParam<const char *> {
protected:
    void SetUp() override {
        if (kAddressSanitizer || kThreadSanitizer)
            GTEST_SKIP() << "the sanitizer has its own memory functions in the place of the C library's";
        // without the heuristics that change its grid
        static_cast<dxOrderedSpace *>(world.space())
            ->setBroadphase(std::make_unique<dxClusteredWorldAndSpace>(dxMakeCrossoverPass(GetParam())));
        world.floor(0);
        for (int i = 0; i < 60; ++i)
            robots.push_back(world.robot(dReal(i % 8) * 3, dReal(i / 8) * 3, dReal(0.4)));
        for (int i = 0; i < 20; ++i) world.wall(dReal(i), dReal(i % 5) * 4, 1, 3);
        for (int i = 0; i < 10; ++i) world.join(robots[2 * i], robots[2 * i + 1]);
    }

    // The way to and fro again and again; allocations of the last of many rounds.
    unsigned allocationsOfWalk(dReal step) {
        unsigned allocations = 0;
        for (int round = 0; round < 30; ++round) {
            g_allocations = 0;
            g_counting = true;
            for (int frame = 0; frame < 8; ++frame) {
                const dReal offset = step * dReal(frame < 4 ? frame : 8 - frame);
                for (std::size_t i = 0; i < robots.size(); i += 2)
                    ClusteredSpace::moveTo(robots[i], dReal(i % 8) * 3 + offset, dReal(i / 8) * 3, dReal(0.4));
                world.space()->collide(&pairs, [](void *count, dGeomID, dGeomID) { ++*static_cast<std::size_t *>(count); });
            }
            g_counting = false;
            allocations = g_allocations;
        }
        return allocations;
    }

    ClusteredSpace world{"auto"};
    std::vector<dGeomID> robots;
    std::size_t pairs = 0;
};

TEST_P(BroadphaseAllocation, CountingWorks) {
    g_allocations = 0;
    g_counting = true;
    void *volatile block = std::malloc(10);
    g_counting = false;
    std::free(block);
    EXPECT_EQ(g_allocations, 1u);
}

TEST_P(BroadphaseAllocation, WithinCellsASearchAllocatesNothing) {
    EXPECT_EQ(allocationsOfWalk(dReal(0.01)), 0u);
    EXPECT_GT(pairs, 0u);
}

TEST_P(BroadphaseAllocation, AcrossCellsASearchAllocatesNothing) {
    EXPECT_EQ(allocationsOfWalk(dReal(1.5)), 0u);
    EXPECT_GT(pairs, 0u);
}

INSTANTIATE_TEST_SUITE_P(Passes, BroadphaseAllocation, testing::ValuesIn(kPasses), nameOfPass);

}  // namespace
