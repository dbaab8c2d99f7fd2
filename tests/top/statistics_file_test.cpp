// The file between a program and its viewer: a reading is of one frame, however fast the frames come.
#include "settings/dxStatisticsFile.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <thread>

namespace {

dODE_MT_WorldStatistics frame(unsigned long long number) {
    dODE_MT_WorldStatistics statistics{};
    statistics.size = sizeof statistics;
    statistics.frames = statistics.rows = statistics.pairs = number;
    statistics.allStepTime = static_cast<double>(number);
    return statistics;
}

TEST(StatisticsFile, IsZeroAtFirstAndKnowsItsVersion) {
    const auto file = std::make_unique<dxStatisticsFile>();
    EXPECT_FALSE(file->isOfThisVersion());
    file->magic = dxStatisticsFile::kMagic;
    file->slotBytes = sizeof(dxStatisticsSlot);
    file->slotCount = dxStatisticsFile::kSlots;
    EXPECT_TRUE(file->isOfThisVersion());
    file->slotBytes += 8;
    EXPECT_FALSE(file->isOfThisVersion());
}

TEST(StatisticsFile, AReadingIsOfOneFrame) {
    const auto file = std::make_unique<dxStatisticsFile>();
    dxStatisticsSlot &slot = file->slots[0];
    std::atomic<bool> isOver{false};
    std::thread writer([&] {
        for (unsigned long long i = 1; i <= 200000; ++i) slot.write(frame(i));
        isOver = true;
    });
    unsigned long long last = 0, readings = 0;
    while (!isOver) {
        dODE_MT_WorldStatistics seen{};
        if (!slot.read(seen)) continue;
        ++readings;
        ASSERT_GE(seen.frames, last);
        ASSERT_EQ(seen.rows, seen.frames);
        ASSERT_EQ(seen.pairs, seen.frames);
        ASSERT_EQ(seen.allStepTime, static_cast<double>(seen.frames));
        last = seen.frames;
    }
    writer.join();
    dODE_MT_WorldStatistics seen{};
    ASSERT_TRUE(slot.read(seen));
    EXPECT_EQ(seen.frames, 200000u);
    EXPECT_GT(readings, 0u);
}

// As a process that was killed leaves it.
TEST(StatisticsFile, ASlotThatWasLeftHalfWrittenIsReadableAfterTheNextFrame) {
    const auto file = std::make_unique<dxStatisticsFile>();
    dxStatisticsSlot &slot = file->slots[0];
    slot.write(frame(1));
    slot.sequence.fetch_add(1);
    dODE_MT_WorldStatistics seen{};
    EXPECT_FALSE(slot.read(seen));
    slot.write(frame(2));
    ASSERT_TRUE(slot.read(seen));
    EXPECT_EQ(seen.frames, 2u);
}

}  // namespace
