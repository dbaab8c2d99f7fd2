// dxOverlappingCandidates against dxBounds::overlaps, on every instruction set of this machine.
#include "instruction_sets.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "RandomBoxes.h"
#include "collision/broadphase/overlap/dxPackedBoxes.h"

namespace {

constexpr dxPackedBoxes::Marks kKnown = dxPackedBoxes::kKnown, kChanged = dxPackedBoxes::kChanged;

std::vector<dxSlotPair> pairsAmong(const dxPackedBoxes &boxes, const std::vector<dxSlotPair> &candidates) {
    constexpr dxSlotPair kUntouched{77777, 77777};
    std::vector<dxSlotPair> pairs(candidates.size() + 1, kUntouched);
    const std::size_t found = dxOverlappingCandidates(boxes, candidates.data(), candidates.size(), pairs.data());
    EXPECT_EQ(pairs.back().a, kUntouched.a) << "written past the room";
    pairs.resize(found);
    return pairs;
}

std::vector<dxSlotPair> allPairsOf(std::uint32_t size) {
    std::vector<dxSlotPair> pairs;
    for (std::uint32_t a = 0; a < size; ++a)
        for (std::uint32_t b = 0; b < size; ++b)
            if (a != b) pairs.push_back({a, b});
    return pairs;
}

TEST(PackedBoxes, PairsAreThoseOfBruteForceWhateverTheBoxesAndMarks) {
    ASSERT_FALSE(instructionSets().empty());
    for (const std::int64_t set : instructionSets()) {
        onInstructionSet(set, [] {
            RandomBoxes random(11);
            std::size_t found = 0;
            for (std::uint32_t size = 0; size < 60; ++size) {
                std::vector<dxBounds> boxes(size);
                std::vector<dxPackedBoxes::Marks> marks(size);
                dxPackedBoxes packed;
                packed.resize(size);
                for (std::uint32_t i = 0; i < size; ++i) {
                    marks[i] = static_cast<dxPackedBoxes::Marks>((random.oneIn(8) ? 0 : kKnown) |
                                                                 (random.oneIn(3) ? 0 : kChanged) | (i % 5) << 2);
                    packed.set(i, boxes[i] = random.box());
                    packed.marks(i) = marks[i];
                }
                const std::vector<dxSlotPair> candidates = allPairsOf(size);
                std::vector<dxSlotPair> expected;
                for (const dxSlotPair &pair : candidates)
                    if ((marks[pair.a] & marks[pair.b] & kKnown) != 0 &&
                        ((marks[pair.a] | marks[pair.b]) & kChanged) != 0 && boxes[pair.a].overlaps(boxes[pair.b]))
                        expected.push_back(pair);
                const std::vector<dxSlotPair> pairs = pairsAmong(packed, candidates);
                ASSERT_EQ(pairs.size(), expected.size());
                for (std::size_t i = 0; i < pairs.size(); ++i) {
                    ASSERT_EQ(pairs[i].a, expected[i].a);
                    ASSERT_EQ(pairs[i].b, expected[i].b);
                }
                found += pairs.size();
            }
            EXPECT_GT(found, 900u);
        });
        if (HasFatalFailure()) return;
    }
}

TEST(PackedBoxes, OfARangeThoseAreFoundThatOverlapOne) {
    for (const std::int64_t set : instructionSets()) {
        onInstructionSet(set, [] {
            RandomBoxes random(12);
            std::size_t found = 0;
            for (std::uint32_t size = 1; size < 60; ++size) {
                std::vector<dxBounds> boxes;
                dxPackedBoxes packed;
                packed.resize(size);
                for (std::uint32_t i = 0; i < size; ++i) {
                    boxes.push_back(random.box());
                    packed.set(i, boxes.back());
                    EXPECT_EQ(std::memcmp(packed.box(i).v, boxes.back().v, sizeof boxes.back().v), 0);
                }
                for (std::uint32_t one = 0; one < size; ++one) {
                    const std::uint32_t first = (7 * one) % size, end = first + (3 * one) % (size - first + 1);
                    std::vector<std::uint32_t> expected;
                    for (std::uint32_t other = first; other < end; ++other)
                        if (boxes[one].overlaps(boxes[other])) expected.push_back(other);
                    std::vector<std::uint32_t> slots(end - first);
                    slots.resize(dxKernelOfOverlappingSlots()(packed, one, first, end, slots.data()));
                    ASSERT_EQ(slots, expected);
                    found += expected.size();
                }
            }
            EXPECT_GT(found, 500u);
        });
        if (HasFatalFailure()) return;
    }
}

TEST(PackedBoxes, TouchingBoxesOverlapAndNaNOverlapsOnItsAxis) {
    for (const std::int64_t set : instructionSets())
        onInstructionSet(set, [] {
            dxPackedBoxes boxes;
            boxes.resize(5);
            boxes.set(0, boundsOf(0, 1, 0, 1, 0, 1));
            boxes.set(1, boundsOf(1, 2, 0, 1, 0, 1));
            boxes.set(2, boundsOf(kNaN, 2, 0, 1, 0, 1));
            boxes.set(3, boundsOf(5, 6, 0, 1, 0, kNaN));
            boxes.set(4, boundsOf(-kInfinite, kInfinite, 0, 1, 0, 1));
            for (std::size_t slot = 0; slot < 5; ++slot) boxes.marks(slot) = kKnown | kChanged;
            EXPECT_EQ(pairsAmong(boxes, {{0, 1}, {1, 0}}).size(), 2u);
            EXPECT_EQ(pairsAmong(boxes, {{0, 2}, {2, 0}}).size(), 2u);
            EXPECT_EQ(pairsAmong(boxes, {{0, 3}, {3, 0}}).size(), 0u);
            EXPECT_EQ(pairsAmong(boxes, {{4, 0}, {0, 4}, {4, 3}, {3, 4}, {4, 2}, {2, 4}}).size(), 6u);
        });
}

}  // namespace
