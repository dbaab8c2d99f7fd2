// dxKeptPairs: pairs in the order of their keys, for any set of new, kept and rejected pairs, on any number of workers.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "collision/pairs/dxKeptPairs.h"

namespace {

using Slot = dxMembers::Slot;

dxGeom *geomOf(Slot slot) {
    static char places[1000];
    return reinterpret_cast<dxGeom *>(&places[slot]);
}

// Keys drawn by lot. The geom with the lower leader is the first; some pairs are refused at either step.
class DrawnOrder final : public dxPairKeys {
public:
    explicit DrawnOrder(unsigned seed) : m_random(seed) {
        for (std::uint64_t &leader : m_leaders) leader = m_random() % 1000000;
    }

    bool primaryKey(Slot a, Slot b, std::uint64_t &word, bool &swapped) const override {
        swapped = std::make_pair(m_leaders[b], b) < std::make_pair(m_leaders[a], a);
        const Slot first = swapped ? b : a;
        word = m_leaders[first] << 10 | first;
        return (a + b) % 11 != 0;
    }

    bool secondaryKey(Slot first, Slot second, dxPairKey &key) const override {
        key.words[1] = (first * 7 + second) % 3;
        key.words[2] = (first + second * 5) % 4;
        key.words[3] = m_leaders[second] << 10 | second;
        return (first * second) % 13 != 0;
    }

    void prefetch(Slot) const override {}

private:
    std::mt19937_64 m_random;
    std::uint64_t m_leaders[1000];
};

// Runs blocks from the last to the first, alternately for each worker.
class Backwards final : public dxTaskRunner {
public:
    unsigned workers() const override { return 3; }
    void run(dxParallelStage, unsigned blocks, dxThreadManager::Task task, void *context) override {
        for (unsigned block = blocks; block-- != 0;) task(context, block, block % 3);
    }
};

class KeptPairs : public testing::Test {
protected:
    KeptPairs() {
        for (Slot slot = 0; slot < kSlots; ++slot) {
            m_members.add(geomOf(slot));
            // A filter without a body, whose bits match.
            m_members.setBounds(slot, dxBounds(), {nullptr, 1, 1});
        }
    }

    std::vector<std::pair<Slot, Slot>> expected() const {
        std::map<std::array<std::uint64_t, 4>, std::pair<Slot, Slot>> byKey;
        for (const dxSlotPair &match : m_all) {
            dxPairKey key;
            bool swapped;
            if (!m_order.primaryKey(match.a, match.b, key.words[0], swapped)) continue;
            const std::pair<Slot, Slot> pair =
                swapped ? std::make_pair(match.b, match.a) : std::make_pair(match.a, match.b);
            if (m_order.secondaryKey(pair.first, pair.second, key)) byKey[key.words] = pair;
        }
        std::vector<std::pair<Slot, Slot>> pairs;
        for (const auto &[key, pair] : byKey) pairs.push_back(pair);
        return pairs;
    }

    void update(dxTaskRunner &runner) {
        std::vector<dxSlotPair> matches;
        for (const dxSlotPair &pair : m_all)
            if (m_members.isChanged(pair.a) || m_members.isChanged(pair.b)) matches.push_back(pair);
        std::shuffle(matches.begin(), matches.end(), m_random);
        m_kept.update(m_members, matches, m_order, runner, m_pairs);
        m_members.forgetChanges();
        const auto wanted = expected();
        ASSERT_EQ(m_pairs.size(), wanted.size());
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            ASSERT_EQ(std::make_pair(m_pairs[i].slots[0], m_pairs[i].slots[1]), wanted[i]) << "place " << i;
            ASSERT_EQ(m_pairs[i].first, geomOf(wanted[i].first));
            ASSERT_EQ(m_pairs[i].second, geomOf(wanted[i].second));
        }
    }

    // Two geoms have hundreds of pairs, others a few.
    void fill() {
        for (Slot b = 1; b < kSlots; ++b) {
            m_all.push_back({0, b});
            if (b > 404) m_all.push_back({b, 400});
            for (Slot a = b > 4 ? b - 4 : 1; a < b; ++a) m_all.push_back({a, b});
        }
    }

    static constexpr Slot kSlots = 1000;
    std::mt19937 m_random{4};
    dxMembers m_members;
    DrawnOrder m_order{5};
    dxKeptPairs m_kept;
    std::vector<dxSlotPair> m_all;
    std::vector<dxOrderedPair> m_pairs;
};

TEST_F(KeptPairs, AreInOrderWhateverChanges) {
    Backwards workers;
    fill();
    for (int round = 0; round < 40; ++round) {
        update(round % 2 == 0 ? static_cast<dxTaskRunner &>(workers) : dxTaskRunner::alone());
        const unsigned share = round % 4 == 3 ? 1 : 7;
        for (Slot slot = 0; slot < kSlots; ++slot)
            if (m_random() % share == 0) m_members.markChanged(slot);
    }
    EXPECT_GT(m_pairs.size(), 3000u);
}

}  // namespace
