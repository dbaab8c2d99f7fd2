// dxRadixSort against std::stable_sort.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "core/dxRadixSort.h"

namespace {

class RadixSort : public testing::TestWithParam<std::uint64_t> {};

TEST_P(RadixSort, SortsAndKeepsTheOrderOfEqualKeys) {
    std::mt19937_64 random(1);
    std::vector<dxSortItem> spare;
    for (const std::size_t size : {0, 1, 2, 63, 64, 65, 1000, 5000}) {
        std::vector<dxSortItem> items;
        for (std::uint32_t i = 0; i < size; ++i) items.push_back({random() & GetParam(), i});
        std::vector<dxSortItem> expected = items;
        std::stable_sort(expected.begin(), expected.end(),
                         [](const dxSortItem &a, const dxSortItem &b) { return a.key < b.key; });
        dxRadixSort(items, spare);
        ASSERT_EQ(items.size(), expected.size());
        for (std::size_t i = 0; i < size; ++i) {
            ASSERT_EQ(items[i].key, expected[i].key) << size << " items, place " << i;
            ASSERT_EQ(items[i].index, expected[i].index) << size << " items, place " << i;
        }
    }
}

TEST_P(RadixSort, SortsNumbersByTheirUpperHalves) {
    std::mt19937_64 random(2);
    std::vector<std::uint64_t> spare;
    for (const std::size_t size : {0, 1, 2, 63, 64, 65, 1000, 5000}) {
        std::vector<std::uint64_t> numbers;
        for (std::uint32_t i = 0; i < size; ++i) numbers.push_back((random() & GetParam()) >> 32 << 32 | i);
        std::vector<std::uint64_t> expected = numbers;
        std::sort(expected.begin(), expected.end());
        dxRadixSort(numbers, spare);
        ASSERT_EQ(numbers, expected);
    }
}

// Which bits of a key vary.
INSTANTIATE_TEST_SUITE_P(Keys, RadixSort,
                         testing::Values(UINT64_C(0), UINT64_C(0xff), UINT64_C(0x7f00), UINT64_C(0xff0000000000ff00),
                                         UINT64_C(0xc000000000000000), ~UINT64_C(0)));

}  // namespace
