// dxTurnedGeom reports a geom that remains transformed, once, and no other.
#include <gtest/gtest.h>

#include <csetjmp>
#include <stdexcept>

#include "collision/narrowphase/dxTurnedGeom.h"
#include "collision/pairs/dxMissedNotifications.h"

namespace {

// Notifications that were missed since it was made.
class Missed {
public:
    std::uint64_t count() const { return dxMissedNotifications::count() - m_before; }

private:
    std::uint64_t m_before = dxMissedNotifications::count();
};

TEST(TurnedGeom, OneThatIsTurnedBackIsNotToldOf) {
    const Missed missed;
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(dxTurnedGeom::whileTurned([] { return 7; }), 7);
        dxTurnedGeom::noticeLeft();
    }
    EXPECT_EQ(missed.count(), 0u);
}

TEST(TurnedGeom, NorOneWithinAnother) {
    const Missed missed;
    dxTurnedGeom::whileTurned([] { return dxTurnedGeom::whileTurned([] { return 0; }); });
    dxTurnedGeom::noticeLeft();
    EXPECT_EQ(missed.count(), 0u);
}

TEST(TurnedGeom, AnExceptionIsToldOfOnce) {
    const Missed missed;
    EXPECT_THROW(dxTurnedGeom::whileTurned([]() -> int { throw std::runtime_error("heights"); }), std::runtime_error);
    EXPECT_EQ(missed.count(), 1u);
    dxTurnedGeom::noticeLeft();
    EXPECT_EQ(missed.count(), 1u);
}

TEST(TurnedGeom, AJumpIsToldOfByTheNextWhoUsesASpace) {
    const Missed missed;
    static std::jmp_buf outside;
    if (setjmp(outside) == 0) dxTurnedGeom::whileTurned([]() -> int { std::longjmp(outside, 1); });
    EXPECT_EQ(missed.count(), 0u) << "no event has been reported yet";
    dxTurnedGeom::noticeLeft();
    dxTurnedGeom::noticeLeft();
    EXPECT_EQ(missed.count(), 1u);
}

TEST(TurnedGeom, AJumpWithinAnotherIsToldOfAtItsEnd) {
    const Missed missed;
    static std::jmp_buf outside;
    dxTurnedGeom::whileTurned([] {
        if (setjmp(outside) == 0) dxTurnedGeom::whileTurned([]() -> int { std::longjmp(outside, 1); });
        return 0;
    });
    EXPECT_EQ(missed.count(), 1u);
    dxTurnedGeom::noticeLeft();
    EXPECT_EQ(missed.count(), 1u);
}

// A function for heights that uses a space: the geom is turned still, and turned back later.
TEST(TurnedGeom, OneThatASpaceIsUsedInIsToldOfThenAndAtItsEnd) {
    const Missed missed;
    dxTurnedGeom::whileTurned([&] {
        dxTurnedGeom::noticeLeft();
        EXPECT_EQ(missed.count(), 1u);
        return 0;
    });
    EXPECT_EQ(missed.count(), 2u);
    dxTurnedGeom::noticeLeft();
    EXPECT_EQ(missed.count(), 2u);
}

}  // namespace
