// dxNeighbours: boxes that overlap are candidates of each other, for any motion.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "RandomBoxes.h"
#include "collision/broadphase/dxNeighbourBroadphase.h"

namespace {

using Slot = dxNeighbours::Slot;

class Neighbours : public testing::Test {
protected:
    void insert(Slot slot, const dxBounds &box) { neighbours.insert(slot, boxes[slot] = box); }
    void move(Slot slot, const dxBounds &box) { neighbours.move(slot, boxes[slot] = box); }
    void remove(Slot slot) {
        neighbours.remove(slot);
        boxes.erase(slot);
    }
    int times(Slot of, Slot candidate) const {
        const auto &all = neighbours.of(of);
        return static_cast<int>(
            std::count_if(all.begin(), all.end(), [&](const auto &c) { return c.slot == candidate; }));
    }

    void expectConsistent() const {
        for (const auto &[a, box] : boxes) {
            const auto &candidates = neighbours.of(a);
            for (std::uint32_t at = 0; at < candidates.size(); ++at) {
                const auto &[other, back] = candidates[at];
                ASSERT_EQ(boxes.count(other), 1u) << other << " is gone";
                ASSERT_NE(other, a);
                ASSERT_LT(back, neighbours.of(other).size());
                ASSERT_EQ(neighbours.of(other)[back].slot, a);
                ASSERT_EQ(neighbours.of(other)[back].back, at);
            }
            for (const auto &[b, otherBox] : boxes)
                ASSERT_TRUE(a == b || !box.overlaps(otherBox) || times(a, b) == 1) << a << " and " << b;
        }
    }

    dxNeighbours neighbours;
    std::map<Slot, dxBounds> boxes;
};

TEST_F(Neighbours, OverlappingBoxesAreCandidatesOfEachOther) {
    insert(0, cubeAt(0, 0, 0));
    insert(5, cubeAt(dReal(0.5), 0, 0));
    insert(2, cubeAt(3, 0, 0));
    EXPECT_EQ(times(0, 5), 1);
    EXPECT_EQ(times(5, 0), 1);
    EXPECT_EQ(times(0, 2), 0);
    remove(5);
    EXPECT_TRUE(neighbours.of(0).empty());
}

TEST_F(Neighbours, ABoxThatMovesOnLosesItsOldCandidates) {
    insert(0, cubeAt(0, 0, 0));
    insert(1, cubeAt(dReal(0.5), 0, 0));
    insert(2, cubeAt(10, 0, 0));
    move(0, cubeAt(dReal(9.8), 0, 0));
    EXPECT_EQ(times(0, 1), 0);
    EXPECT_EQ(times(0, 2), 1);
}

TEST_F(Neighbours, SmallStepsAddUp) {
    insert(0, cubeAt(0, 0, 0));
    insert(1, cubeAt(5, 0, 0));
    for (int step = 0; step <= 500; ++step) move(0, cubeAt(dReal(step) / 100, 0, 0));
    EXPECT_EQ(times(0, 1), 1);
    for (int step = 0; step <= 500; ++step) move(0, cubeAt(5 + dReal(step) / 100, 0, 0));
    EXPECT_EQ(times(0, 1), 0);
}

TEST_F(Neighbours, EveryOverlapIsACandidateWhateverTheBoxes) {
    RandomBoxes random(3);
    for (int round = 0; round < 6000; ++round) {
        const Slot slot = random.below(80);
        if (boxes.count(slot) == 0) {
            insert(slot, random.box());
        } else if (random.oneIn(5)) {
            remove(slot);
        } else if (random.oneIn(3)) {
            move(slot, random.box());
        } else {
            dxBounds box = boxes[slot];
            const dReal step = random.uniform(dReal(-0.2), dReal(0.2)) * (box.v[1] - box.v[0]);
            box.v[0] += step;
            box.v[1] += step;
            move(slot, box);
        }
        if (round % 20 == 0) expectConsistent();
        if (HasFatalFailure()) return;
    }
}

// The candidate of a box that moves slowly is near: within the two margins. Else a space of many geoms would compare all with all.
TEST_F(Neighbours, CandidatesAreNear) {
    RandomBoxes random(4);
    for (Slot slot = 0; slot < 300; ++slot) insert(slot, random.properBox());
    for (int round = 0; round < 60; ++round) {
        for (Slot slot = 0; slot < 300; ++slot) {
            dxBounds box = boxes[slot];
            const dReal step = random.uniform(dReal(-0.012), dReal(0.012)) * box.longestEdge();
            for (dReal &bound : box.v) bound += step;
            move(slot, box);
        }
        for (const auto &[a, box] : boxes)
            for (const auto &candidate : neighbours.of(a)) {
                const dxBounds &other = boxes[candidate.slot];
                const dReal margin = dReal(0.21);
                ASSERT_TRUE(box.grown(margin * box.longestEdge()).overlaps(other.grown(margin * other.longestEdge())));
            }
    }
}

}  // namespace
