// The counters have 64 bits; the older calls show the lower half of each.
//
// Covers api/ode_MT.cpp.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include "OdeSession.h"
#include "PackedWorld.h"
#include "settings/dxProcessStatistics.h"

namespace {

TEST(Statistics, CountBeyond32Bits) {
    dODE_MT_Statistics before, after;
    dODE_MT_GetStatistics(&before);
    const unsigned low = dODE_MT_GetContactsAhead();
    constexpr std::uint64_t kMany = (std::uint64_t{1} << 32) + 5;
    dxProcessStatistics::instance().countSharedCollision(2, kMany, kMany - 7);
    dODE_MT_GetStatistics(&after);
    EXPECT_EQ(after.contactsAhead - before.contactsAhead, kMany);
    EXPECT_EQ(after.contactsAheadUnused - before.contactsAheadUnused, 7u);
    EXPECT_EQ(after.sharedCollisions - before.sharedCollisions, 1u);
    EXPECT_EQ(dODE_MT_GetContactsAhead() - low, 5u);
    EXPECT_EQ(dODE_MT_GetContactsAhead(), static_cast<unsigned>(after.contactsAhead));
    EXPECT_EQ(dODE_MT_GetContactsAheadUnused(), static_cast<unsigned>(after.contactsAheadUnused));
    EXPECT_EQ(dODE_MT_GetSharedCollisions(), static_cast<unsigned>(after.sharedCollisions));
}

// One island; others may have had the processors, so that a worker came too late.
TEST(Statistics, ALargeIslandStepCountsOnce) {
    const OdeSession session(3, "lcp");
    constexpr unsigned kFrames = 3, kTries = 20;
    for (unsigned i = 0; i < kTries; ++i) {
        PackedWorld boxes(10, 10, 2, dWorldQuickStep);
        const unsigned before = dODE_MT_GetTeamSteps();
        for (unsigned frame = 0; frame < kFrames; ++frame) boxes.frame();
        const unsigned counted = dODE_MT_GetTeamSteps() - before;
        ASSERT_LE(counted, kFrames);
        if (counted == kFrames) return;
    }
    FAIL() << "not all steps were counted";
}

TEST(Statistics, NoPlaceIsAMessage) {
    testing::internal::CaptureStderr();
    dODE_MT_GetStatistics(nullptr);
    EXPECT_NE(testing::internal::GetCapturedStderr().find("no place"), std::string::npos);
}

}  // namespace
