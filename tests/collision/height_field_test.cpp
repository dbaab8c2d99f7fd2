// dxTransformedGeom reports a geom that remains transformed, once, and no other.
#include <gtest/gtest.h>

#include <csetjmp>
#include <stdexcept>

#include "collision/narrowphase/dxHeightField.h"
#include "collision/pairs/dxUnnoticedChanges.h"

namespace {

// Notifications that were missed since it was made.
class Missed {
public:
    std::uint64_t count() const { return dxMissedNotifications.count() - m_before; }

private:
    std::uint64_t m_before = dxMissedNotifications.count();
};

TEST(TransformedGeom, IsNotReportedOnceRestored) {
    const Missed missed;
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(dxTransformedGeom::whileTransformed([] { return 7; }), 7);
        dxTransformedGeom::noticeLeft();
    }
    EXPECT_EQ(missed.count(), 0u);
}

TEST(TransformedGeom, IsNotReportedOnceRestoredWithinAnotherCollision) {
    const Missed missed;
    dxTransformedGeom::whileTransformed([] { return dxTransformedGeom::whileTransformed([] { return 0; }); });
    dxTransformedGeom::noticeLeft();
    EXPECT_EQ(missed.count(), 0u);
}

TEST(TransformedGeom, AnExceptionIsReportedOnce) {
    const Missed missed;
    EXPECT_THROW(dxTransformedGeom::whileTransformed([]() -> int { throw std::runtime_error("heights"); }), std::runtime_error);
    EXPECT_EQ(missed.count(), 1u);
    dxTransformedGeom::noticeLeft();
    EXPECT_EQ(missed.count(), 1u);
}

TEST(TransformedGeom, AJumpIsReportedByTheNextUseOfASpace) {
    const Missed missed;
    static std::jmp_buf outside;
    if (setjmp(outside) == 0) dxTransformedGeom::whileTransformed([]() -> int { std::longjmp(outside, 1); });
    EXPECT_EQ(missed.count(), 0u) << "no event has been reported yet";
    dxTransformedGeom::noticeLeft();
    dxTransformedGeom::noticeLeft();
    EXPECT_EQ(missed.count(), 1u);
}

TEST(TransformedGeom, AJumpWithinAnotherCollisionIsReportedAtItsEnd) {
    const Missed missed;
    static std::jmp_buf outside;
    dxTransformedGeom::whileTransformed([] {
        if (setjmp(outside) == 0) dxTransformedGeom::whileTransformed([]() -> int { std::longjmp(outside, 1); });
        return 0;
    });
    EXPECT_EQ(missed.count(), 1u);
    dxTransformedGeom::noticeLeft();
    EXPECT_EQ(missed.count(), 1u);
}

// The height function uses a space while the geom is transformed; the geom is restored later.
TEST(TransformedGeom, IsReportedWhenASpaceIsUsedAndAtTheEnd) {
    const Missed missed;
    dxTransformedGeom::whileTransformed([&] {
        dxTransformedGeom::noticeLeft();
        EXPECT_EQ(missed.count(), 1u);
        return 0;
    });
    EXPECT_EQ(missed.count(), 2u);
    dxTransformedGeom::noticeLeft();
    EXPECT_EQ(missed.count(), 2u);
}

}  // namespace
