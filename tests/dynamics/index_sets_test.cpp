// The sets C and N have the positions that upstream's swaps give them, and C the order of its factorisation.
#include "dynamics/world_step/exact/dxIndexSets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace {

// The same by definition: a list of indexes, of which upstream swaps two, and a list of those of C in the order of the factorisation.
struct Model {
    Model(unsigned n, unsigned bilateral) : indexes(n), countC(bilateral) {
        std::iota(indexes.begin(), indexes.end(), 0u);
        factor.assign(indexes.begin(), indexes.begin() + bilateral);
    }

    void moveToC(unsigned position) {
        std::swap(indexes[countC], indexes[position]);
        factor.push_back(indexes[countC++]);
    }
    void moveFromCToN(unsigned position) {
        factor.erase(std::find(factor.begin(), factor.end(), indexes[position]));
        std::swap(indexes[position], indexes[--countC]);
        ++countN;
    }

    std::vector<unsigned> indexes, factor;
    unsigned countC, countN = 0;
};

void expectSame(const dxIndexSets &sets, const Model &model) {
    ASSERT_EQ(sets.countC(), model.countC);
    ASSERT_EQ(sets.countN(), model.countN);
    for (unsigned i = 0; i < model.indexes.size(); ++i) ASSERT_EQ(sets.indexAt(i), model.indexes[i]);
    for (unsigned row = 0; row < model.countC; ++row) {
        ASSERT_EQ(sets.factorIndexes()[row], model.factor[row]);
        ASSERT_EQ(sets.indexAt(sets.factorPositions()[row]), model.factor[row]);
        ASSERT_EQ(sets.factorRowAt(sets.factorPositions()[row]), row);
    }
    for (unsigned i = 0; i < sets.inPlace(); ++i) {
        ASSERT_EQ(sets.indexAt(i), i);
        ASSERT_EQ(sets.factorPositions()[i], i);
    }
}

}  // namespace

TEST(IndexSets, FollowUpstreamsSwaps) {
    for (unsigned seed = 0; seed < 200; ++seed) {
        std::mt19937 random(seed);
        const unsigned n = 2 + random() % 30, bilateral = random() % n;
        std::vector<unsigned> storage(dxIndexSets::kWords * n);
        dxIndexSets sets(n, bilateral, storage.data());
        Model model(n, bilateral);
        while (model.countC + model.countN < n) {
            switch (random() % 4) {
                case 0:
                    model.moveToC(model.countC + model.countN);
                    sets.addNextToC();
                    break;
                case 1:
                    ++model.countN;
                    sets.addNextToN();
                    break;
                case 2:
                    if (model.countN > 0) {
                        const unsigned position = model.countC + random() % model.countN;
                        --model.countN;
                        model.moveToC(position);
                        sets.moveFromNToC(position);
                    }
                    break;
                default:
                    if (model.countC > bilateral) {
                        const unsigned position = bilateral + random() % (model.countC - bilateral);
                        const unsigned factorRow = sets.factorRowAt(position);
                        model.moveFromCToN(position);
                        sets.moveFromCToN(position, factorRow);
                    }
            }
            ASSERT_NO_FATAL_FAILURE(expectSame(sets, model)) << seed;
        }
    }
}

// While no row has been in N, all of C is in place.
TEST(IndexSets, AreInPlaceAtFirst) {
    std::vector<unsigned> storage(dxIndexSets::kWords * 10);
    dxIndexSets sets(10, 3, storage.data());
    for (unsigned i = 3; i < 10; ++i) {
        EXPECT_EQ(sets.inPlace(), i);
        sets.addNextToC();
    }
}
