// dxBoxColumns: dxOverlappingRows and dxOverlappingPairs against dxBounds::overlaps, on every instruction set of this machine.
#include "instruction_sets.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "RandomBoxes.h"
#include "collision/broadphase/overlap/dxBoxColumns.h"

namespace {

std::vector<std::uint32_t> bruteForce(const std::vector<dxBounds> &boxes, const dxBounds &box, std::size_t first) {
    std::vector<std::uint32_t> rows;
    for (std::size_t row = first; row < boxes.size(); ++row)
        if (box.overlaps(boxes[row])) rows.push_back(static_cast<std::uint32_t>(row));
    return rows;
}

std::vector<std::uint32_t> overlapping(const dxBoxColumns &table, const dxBounds &box, std::size_t first) {
    std::vector<std::uint32_t> rows(table.size() + 1, 77777);
    const std::size_t count = dxOverlappingRows(table, box, first, table.size(), rows.data());
    EXPECT_EQ(rows.back(), 77777u) << "written past the table's size";
    rows.resize(count);
    return rows;
}

TEST(BoxColumns, RowsAreThoseOfBruteForceWhateverTheBoxes) {
    ASSERT_FALSE(instructionSets().empty());
    for (const std::int64_t set : instructionSets()) {
        onInstructionSet(set, [] {
            RandomBoxes random(5);
            std::size_t found = 0;
            dxBoxColumns table;
            for (std::size_t size = 0; size < 100; ++size) {
                table.clear();
                std::vector<dxBounds> boxes;
                for (std::size_t i = 0; i < size; ++i) table.push(boxes.emplace_back(random.box()));
                ASSERT_EQ(table.size(), size);
                for (std::size_t first = 0; first <= size; ++first) {
                    const dxBounds box = random.box();
                    const auto rows = overlapping(table, box, first);
                    ASSERT_EQ(rows, bruteForce(boxes, box, first)) << size << " rows, from " << first;
                    found += rows.size();
                }
            }
            EXPECT_GT(found, 3000u);
        });
        if (HasFatalFailure()) return;
    }
}

// What a table held before it was cleared lies behind its last row.
TEST(BoxColumns, OldRowsBehindTheLastAreNotFound) {
    for (const std::int64_t set : instructionSets())
        onInstructionSet(set, [] {
            dxBoxColumns table;
            for (int i = 0; i < 200; ++i) table.push(cubeAt(0, 0, 0));
            for (std::size_t size = 0; size < 40; ++size) {
                table.clear();
                for (std::size_t i = 0; i < size; ++i) table.push(cubeAt(0, 0, 0));
                ASSERT_EQ(overlapping(table, cubeAt(0, 0, 0), 0).size(), size);
            }
        });
}

TEST(BoxColumns, TouchingBoxesOverlapAndNaNOverlapsOnItsAxis) {
    for (const std::int64_t set : instructionSets())
        onInstructionSet(set, [] {
            dxBoxColumns table;
            table.push(boundsOf(1, 2, 0, 1, 0, 1));
            table.push(boundsOf(kNaN, 2, 0, 1, 0, 1));
            table.push(boundsOf(5, 6, 0, 1, 0, kNaN));
            table.push(boundsOf(-kInfinite, kInfinite, 0, 1, 0, 1));
            EXPECT_EQ(overlapping(table, boundsOf(0, 1, 0, 1, 0, 1), 0), (std::vector<std::uint32_t>{0, 1, 3}));
            EXPECT_EQ(overlapping(table, boundsOf(kNaN, kNaN, 1, 1, 1, 1), 1), (std::vector<std::uint32_t>{1, 2, 3}));
        });
}

TEST(BoxColumns, PairsAreThoseOfTheRowsOneByOne) {
    for (const std::int64_t set : instructionSets()) {
        onInstructionSet(set, [] {
            RandomBoxes random(6);
            std::size_t found = 0;
            for (std::size_t size = 0; size < 70; ++size) {
                dxBoxColumns table;
                for (std::size_t i = 0; i < size; ++i) table.push(random.box());
                for (const std::size_t end : {std::size_t{0}, size / 2, size}) {
                    std::vector<dxSlotPair> expected, pairs;
                    for (std::uint32_t row = 0; row < end; ++row)
                        for (const std::uint32_t other : overlapping(table, table.row(row), row + 1))
                            expected.push_back({row, other});
                    ASSERT_EQ(dxOverlappingPairs(table, end, pairs), expected.size());
                    for (std::size_t i = 0; i < expected.size(); ++i) {
                        ASSERT_EQ(pairs[i].a, expected[i].a);
                        ASSERT_EQ(pairs[i].b, expected[i].b);
                    }
                    found += expected.size();
                }
            }
            EXPECT_GT(found, 2000u);
        });
        if (HasFatalFailure()) return;
    }
}

TEST(BoxColumns, RowsKeepTheirBoxesAsTheTableGrows) {
    RandomBoxes random(7);
    dxBoxColumns table;
    std::vector<dxBounds> boxes;
    for (std::size_t i = 0; i < 100; ++i) table.push(boxes.emplace_back(random.box()));
    for (std::size_t i = 0; i < 100; i += 3) table.set(i, boxes[i] = random.box());
    for (std::size_t i = 0; i < 100; ++i) EXPECT_EQ(std::memcmp(table.row(i).v, boxes[i].v, sizeof boxes[i].v), 0) << i;
}

}  // namespace
