// The step arena: arrays do not overlap and begin at cache lines, and an arena that has seen a step allocates nothing in the next one.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "core/dxStepArena.h"

namespace {

TEST(StepArena, GivesSeparateArraysAtCacheLines) {
    dxStepArena arena;
    std::vector<dxArenaArray<unsigned>> arrays;
    for (unsigned i = 0; i < 200; ++i) {
        arrays.push_back(arena.takeFilled(1 + 37 * i, i));
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(arrays.back().data()) % kCacheLine, 0u);
        EXPECT_EQ(arrays.back().size(), 1 + 37 * i);
    }
    for (unsigned i = 0; i < arrays.size(); ++i)
        for (const unsigned item : arrays[i]) EXPECT_EQ(item, i);
}

TEST(StepArena, KeepsMemoryFromStepToStep) {
    dxStepArena arena;
    std::size_t capacity = 0;
    for (unsigned step = 0; step < 4; ++step) {
        arena.reset();
        if (step == 2) capacity = arena.capacity();
        for (unsigned i = 1; i < 300; ++i) arena.take<double>(10 * i);
    }
    EXPECT_EQ(arena.capacity(), capacity);
    EXPECT_GE(capacity, sizeof(double) * 10 * 299 * 300 / 2);
    EXPECT_LE(capacity, 4 * sizeof(double) * 10 * 299 * 300 / 2);
}

TEST(StepArena, ProvidesWhatAnotherOneHas) {
    dxStepArena first, second;
    for (unsigned i = 1; i < 100; ++i) first.take<double>(10 * i);
    second.reserve(first.capacity());
    EXPECT_GE(second.capacity(), first.capacity());
    const std::size_t capacity = second.capacity();
    for (unsigned i = 1; i < 100; ++i) second.take<double>(10 * i);
    EXPECT_EQ(second.capacity(), capacity);
}

TEST(StepArena, ListsItemsUpToTheirRoom) {
    dxStepArena arena;
    dxArenaArray<int> list = arena.takeList<int>(3);
    EXPECT_TRUE(list.empty());
    for (const int item : {5, 6, 7}) list.push(item);
    const dxArenaArray<const int> items = list;
    EXPECT_EQ(std::vector<int>(items.begin(), items.end()), (std::vector<int>{5, 6, 7}));
    EXPECT_EQ(list.back(), 7);
}

}  // namespace
