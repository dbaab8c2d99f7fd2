// dxSapSort against a sort by digits that keeps its ranks, as upstream's is described: three passes from the lowest byte
// up, then one in which negative numbers are counted down and taken from the back.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <random>

#include "collision/spaces/sweep_and_prune/dxSapSort.h"

namespace {

using Keys = std::vector<float>;
using Ranks = std::vector<std::uint32_t>;

class SortByDigits {
public:
    const Ranks &sort(const Keys &keys) {
        if (m_ranks.size() != keys.size()) {
            m_ranks.resize(keys.size());
            std::iota(m_ranks.begin(), m_ranks.end(), 0u);
        }
        bool inOrder = true;
        for (std::size_t i = 1; i < m_ranks.size(); ++i) inOrder = inOrder && !(keys[m_ranks[i]] < keys[m_ranks[i - 1]]);
        if (inOrder) return m_ranks;
        for (int byte = 0; byte < 4; ++byte) distribute(keys, byte);
        return m_ranks;
    }

private:
    void distribute(const Keys &keys, int byte) {
        std::array<Ranks, 256> buckets;
        for (const std::uint32_t index : m_ranks) {
            std::uint32_t bits;
            std::memcpy(&bits, &keys[index], sizeof bits);
            buckets[bits >> (8 * byte) & 255].push_back(index);
        }
        m_ranks.clear();
        for (int i = 0; byte == 3 && i < 128; ++i) {
            const Ranks &bucket = buckets[static_cast<std::size_t>(255 - i)];
            m_ranks.insert(m_ranks.end(), bucket.rbegin(), bucket.rend());
        }
        for (int i = 0; i < (byte == 3 ? 128 : 256); ++i) {
            const Ranks &bucket = buckets[static_cast<std::size_t>(i)];
            m_ranks.insert(m_ranks.end(), bucket.begin(), bucket.end());
        }
    }

    Ranks m_ranks;
};

struct Mixture {
    const char *name;
    float (*make)(std::mt19937 &random);
};
void PrintTo(const Mixture &mixture, std::ostream *out) { *out << mixture.name; }

float uniform(std::mt19937 &random, float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random);
}

float any(std::mt19937 &random) {
    const auto bits = static_cast<std::uint32_t>(random());
    float number;
    std::memcpy(&number, &bits, sizeof number);
    return number;
}

float fewNumbers(std::mt19937 &random) { return std::trunc(uniform(random, -4, 4)); }  // -0 too

float fewOdd(std::mt19937 &random) {
    constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float odd[] = {inf, -inf, nan, -nan, 0.0f, -0.0f, 1e-40f, -1e-40f, 3e38f, -3e38f, 1, -1};
    return odd[random() % std::size(odd)];
}

class RankSort : public testing::TestWithParam<Mixture> {};

TEST_P(RankSort, KeepsTheOrderThatEarlierCallsHaveLeft) {
    std::mt19937 random(1);
    for (int run = 0; run < 60; ++run) {
        dxSapSort sort;
        SortByDigits expected;
        Keys keys;
        for (int call = 0; call < 30; ++call) {
            const bool resizes = call == 0 || random() % 6 == 0;
            if (resizes) keys.resize(1 + random() % (run % 3 == 0 ? 400 : 20));
            const std::size_t changes = resizes ? keys.size() * 3 : random() % 3 == 0 ? 0 : random() % (keys.size() + 1);
            for (std::size_t i = 0; i < changes; ++i) keys[random() % keys.size()] = GetParam().make(random);
            ASSERT_EQ(sort.sort(keys), expected.sort(keys)) << "run " << run << ", call " << call;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Keys, RankSort,
                         testing::Values(Mixture{"positive", [](std::mt19937 &r) { return uniform(r, 1, 9); }},
                                         Mixture{"negative", [](std::mt19937 &r) { return uniform(r, -9, -1); }},
                                         Mixture{"both", [](std::mt19937 &r) { return uniform(r, -9, 9); }},
                                         Mixture{"ties", fewNumbers},
                                         Mixture{"negativeTies", [](std::mt19937 &r) { return -1 - std::fabs(fewNumbers(r)); }},
                                         Mixture{"odd", fewOdd}, Mixture{"any", any}),
                         [](const auto &info) { return std::string(info.param.name); });

TEST(RankSort, EqualNegativeNumbersAreReversedWheneverOthersAreSorted) {
    dxSapSort sort;
    EXPECT_EQ(sort.sort({-1, -1, -1}), (Ranks{0, 1, 2})) << "in order as they are";
    EXPECT_EQ(sort.sort({-1, -1, -2}), (Ranks{2, 1, 0}));
    EXPECT_EQ(sort.sort({-1, -1, -1}), (Ranks{2, 1, 0})) << "in order as they were";
    EXPECT_EQ(sort.sort({-1, -1}), (Ranks{0, 1})) << "another number of them: from the beginning";
}

}  // namespace
