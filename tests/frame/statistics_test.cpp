// The counters have 64 bits; the older calls show the lower half of each.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include "frame/dxStepStatistics.h"

namespace {

TEST(Statistics, CountBeyond32Bits) {
    dODE_MT_Statistics before, after;
    dODE_MT_GetStatistics(&before);
    const unsigned low = dODE_MT_GetContactsAhead();
    constexpr std::uint64_t kMany = (std::uint64_t{1} << 32) + 5;
    dxStepStatistics::instance().countSharedCollision(2, kMany, kMany - 7);
    dODE_MT_GetStatistics(&after);
    EXPECT_EQ(after.contactsAhead - before.contactsAhead, kMany);
    EXPECT_EQ(after.contactsAheadUnused - before.contactsAheadUnused, 7u);
    EXPECT_EQ(after.sharedCollisions - before.sharedCollisions, 1u);
    EXPECT_EQ(dODE_MT_GetContactsAhead() - low, 5u);
    EXPECT_EQ(dODE_MT_GetContactsAhead(), static_cast<unsigned>(after.contactsAhead));
    EXPECT_EQ(dODE_MT_GetSharedCollisions(), static_cast<unsigned>(after.sharedCollisions));
}

TEST(Statistics, NoPlaceIsAMessage) {
    testing::internal::CaptureStderr();
    dODE_MT_GetStatistics(nullptr);
    EXPECT_NE(testing::internal::GetCapturedStderr().find("no place"), std::string::npos);
}

}  // namespace
