// dxVerletBroadphase: its lists serve many calls while boxes move a little, whatever moves beside them; none is made while
// boxes jump about. That it finds what all searches find is broadphase_test's.
#include <gtest/gtest.h>

#include <vector>

#include "../threading/manager_runner.h"
#include "RandomBoxes.h"
#include "BroadphaseMembers.h"
#include "collision/broadphase/dxVerletBroadphase.h"

namespace {

using Slot = BroadphaseMembers::Slot;

class VerletBroadphase : public testing::Test {
protected:
    VerletBroadphase() {
        for (Slot i = 0; i < kBoxes; ++i) {
            m_members.add(cubeAt(somewhere(), somewhere(), somewhere()));
            m_ways.push_back({m_random.uniform(-1, 1), m_random.uniform(-1, 1), m_random.uniform(-1, 1)});
        }
    }

    dReal somewhere() { return m_random.uniform(-6, 6); }

    void move(Slot slot, dReal share) {
        dxBounds box = m_members.members()[slot].bounds;
        for (int bound = 0; bound < 6; ++bound) box.v[bound] += share * m_ways[slot].by[bound / 2];
        m_members.move(slot, box);
    }

    void check() {
        const auto expected = m_members.expected();
        m_pairs += expected.size();
        ASSERT_EQ(m_members.found(m_broadphase), expected);
    }

    struct Way {
        dReal by[3];
    };

    static constexpr Slot kBoxes = 300;
    RandomBoxes m_random{21};
    BroadphaseMembers m_members;
    std::vector<Way> m_ways;
    dxVerletBroadphase m_broadphase;
    std::size_t m_pairs = 0;
};

TEST_F(VerletBroadphase, AListServesManyCallsOfBoxesThatTravel) {
    for (int call = 0; call < 100; ++call) {
        for (Slot slot = 0; slot < kBoxes; ++slot) move(slot, 0.02);
        check();
    }
    EXPECT_LT(m_broadphase.lists(), 25u);
    EXPECT_GT(m_pairs, 10000u);
}

// Back and forth, at rest for a while, some at a time: boxes leave the stored ones at every side.
TEST_F(VerletBroadphase, FindsWhatOverlapsWhileBoxesTurnRestAndLeave) {
    for (int call = 0; call < 200; ++call) {
        for (Slot slot = 0; slot < kBoxes; ++slot) {
            if (m_random.oneIn(10)) m_ways[slot].by[m_random.below(3)] *= -1;
            if ((static_cast<int>(slot) + call) % 7 < 5) move(slot, m_random.oneIn(40) ? 1 : 0.03);
        }
        check();
    }
    EXPECT_LT(m_broadphase.lists(), 100u);
}

// Some members are always about to leave their stored boxes, others are added and removed; slots are reused.
TEST_F(VerletBroadphase, GrowsForAFewWithoutANewList) {
    for (int call = 0; call < 60; ++call) {
        const Slot slot = m_random.below(kBoxes);
        if (!m_members.isThere(slot))
            m_members.add(m_random.oneIn(4) ? m_random.box() : cubeAt(somewhere(), somewhere(), somewhere()));
        else if (m_random.oneIn(2))
            m_members.remove(slot);
        else
            m_members.move(slot, m_random.oneIn(4) ? m_random.box() : cubeAt(somewhere(), somewhere(), somewhere()));
        check();
    }
    EXPECT_LT(m_broadphase.lists(), 15u);
}

// Stored boxes that hold a box before and after a jump overlap nearly all others.
TEST_F(VerletBroadphase, AListStaysShortWhileAFewJump) {
    check();
    const std::size_t fresh = m_broadphase.candidates();
    for (int call = 0; call < 100; ++call) {
        for (int i = 0; i < 4; ++i)
            m_members.move(m_random.below(kBoxes), cubeAt(somewhere(), somewhere(), somewhere()));
        check();
        ASSERT_LT(m_broadphase.candidates(), 3 * (fresh + kBoxes));
    }
    EXPECT_LT(m_broadphase.lists(), 50u);
}

TEST_F(VerletBroadphase, DoesWithoutListsWhileBoxesJump) {
    for (int call = 0; call < 100; ++call) {
        for (Slot slot = 0; slot < kBoxes; ++slot) m_members.move(slot, cubeAt(somewhere(), somewhere(), somewhere()));
        check();
    }
    EXPECT_LT(m_broadphase.lists(), 15u);
    for (int call = 0; call < 100; ++call) {
        for (Slot slot = 0; slot < kBoxes; ++slot) move(slot, 0.01);
        check();
    }
    EXPECT_LT(m_broadphase.lists(), 40u);
}

// The number of members is large enough for parallel chunks of members and candidates.
TEST(SharedVerletSearch, FindsWhatItFindsAlone) {
    ManagerRunner workers(3);
    RandomBoxes random(22);
    BroadphaseMembers crowd;
    dxVerletBroadphase search;
    const auto somewhere = [&] { return random.uniform(-8, 8); };
    for (Slot slot = 0; slot < 2000; ++slot) crowd.add(cubeAt(somewhere(), somewhere(), somewhere()));
    for (int call = 0; call < 30; ++call) {
        for (Slot slot = 0; slot < 2000; ++slot) {
            dxBounds box = crowd.members()[slot].bounds;
            const dReal way = random.oneIn(200) ? 3 : random.uniform(-0.02, 0.02);
            for (dReal &bound : box.v) bound += way;
            crowd.move(slot, box);
        }
        const auto expected = crowd.expected();
        ASSERT_EQ(crowd.found(search, workers), expected);
    }
    EXPECT_GT(search.candidates(), 3000u);
    EXPECT_LT(search.lists(), 20u);
}

}  // namespace
