// dxKernelOfMeetBehind against comparing each row with each.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "collision/broadphase/overlap/dxAxisSap.h"

namespace {

struct Box {
    double low, high, low1, high1, low2, high2;
};
using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

Pairs expected(const std::vector<Box> &boxes) {
    Pairs pairs;
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
        for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
            const Box &a = boxes[i], &b = boxes[j];
            if (b.low <= a.high && a.high1 >= b.low1 && b.high1 >= a.low1 && a.high2 >= b.low2 && b.high2 >= a.low2)
                pairs.emplace_back(i, j);
        }
    return pairs;
}

Pairs swept(const std::vector<Box> &boxes, dxSapColumns &rows) {
    rows.resize(boxes.size());
    for (std::size_t row = 0; row < boxes.size(); ++row) rows.set(row, boxes[row]);
    std::vector<std::uint32_t> met(boxes.size());
    Pairs pairs;
    for (std::uint32_t row = 0; row < boxes.size(); ++row) {
        const std::size_t count = dxKernelOfMeetBehind()(rows, row, met.data()).rows;
        for (std::size_t i = 0; i < count; ++i) pairs.emplace_back(row, met[i]);
    }
    return pairs;
}

TEST(AxisSap, FindsWhatComparingEachWithEachFinds) {
    constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    std::mt19937 random(1);
    const auto bound = [&](double low, double high, bool odd) {
        constexpr double oddOnes[] = {inf, -inf, nan, 0.0, -0.0, 1e300, -1e300};
        return odd && random() % 9 == 0 ? oddOnes[random() % std::size(oddOnes)]
                                        : std::uniform_real_distribution<double>(low, high)(random);
    };
    dxSapColumns rows;
    for (int run = 0; run < 300; ++run) {
        std::vector<Box> boxes(random() % 70);
        const bool odd = run % 2 == 0;
        for (Box &box : boxes) {
            box.low = bound(-9, 9, odd);
            if (box.low != box.low) box.low = 0;
            if (run % 3 == 0) box.low = std::trunc(box.low);
            box.high = odd ? bound(-9, 9, odd) : box.low + bound(0, 4, odd);
            box.low1 = bound(-9, 9, odd);
            box.high1 = box.low1 + bound(0, 6, odd);
            box.low2 = bound(-9, 9, odd);
            box.high2 = box.low2 + bound(0, 6, odd);
        }
        std::sort(boxes.begin(), boxes.end(), [](const Box &a, const Box &b) { return a.low < b.low; });
        ASSERT_EQ(swept(boxes, rows), expected(boxes)) << run;
    }
}

TEST(AxisSap, RowsBehindTheLastOverlapNothing) {
    dxSapColumns rows;
    const Box everywhere{0, 9, 0, 9, 0, 9};
    EXPECT_EQ(swept(std::vector<Box>(30, everywhere), rows).size(), 30u * 29 / 2);
    EXPECT_EQ(swept(std::vector<Box>(2, everywhere), rows).size(), 1u);
    EXPECT_TRUE(swept({everywhere}, rows).empty());
    EXPECT_TRUE(swept({}, rows).empty());
}

}  // namespace
