// The parts of a partition lie apart and weigh the same.
#include "dynamics/quick_step/sor/dxBodyPartition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace {

// Bodies along a line, each a row heavier than the one before it: the parts lie apart and weigh the same.
TEST(BodyPartition, PartsLieApartAndWeighTheSame) {
    constexpr unsigned kBodies = 1000, kParts = 5;
    std::vector<dxPlace> places;
    std::vector<unsigned> weights;
    unsigned all = 0;
    for (unsigned body = 0; body < kBodies; ++body) {
        const unsigned along = body * 7 % kBodies;  // in any order
        places.push_back({{1, dReal(along), dReal(along % 3)}});
        weights.push_back(along);
        all += along;
    }
    dxBodyPartition partition;
    partition.partition(places, weights, kParts);
    std::vector<unsigned> weightOf(kParts);
    std::vector<dReal> low(kParts, kBodies), high(kParts, -1);
    for (unsigned body = 0; body < kBodies; ++body) {
        const std::size_t part = partition.partitionOf(body);
        weightOf[part] += weights[body];
        low[part] = std::min(low[part], places[body].at[1]);
        high[part] = std::max(high[part], places[body].at[1]);
    }
    for (unsigned part = 0; part < kParts; ++part) {
        EXPECT_NEAR(weightOf[part], all / kParts, all / kParts / 10) << part;
        if (part > 0) { EXPECT_LT(high[part - 1], low[part]); }
    }
}

}  // namespace
