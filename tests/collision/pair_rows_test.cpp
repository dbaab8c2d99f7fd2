// dxPairRows, dxHashRows and dxSapRows against what upstream's spaces do, step by step.
//
// Covers dxHashPairOrder.cpp, dxSapPairOrder.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

#include "collision/spaces/hash/dxHashPairOrder.h"
#include "collision/spaces/sweep_and_prune/dxSapPairOrder.h"
#include "config.h"

namespace {

struct Thing {
    dxBounds box;
    dxPairFilter filter;
};
using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;  // numbers of things

// Rows do not read geoms.
dxGeom *geomOf(std::uint32_t thing) { return reinterpret_cast<dxGeom *>(static_cast<std::uintptr_t>(thing + 1)); }

Pairs pairsOf(dxPairRows &rows) {
    Pairs pairs;
    for (std::size_t row = 0; row < rows.rows(); ++row) {
        const std::size_t count = rows.find(row);
        const std::uint32_t first = rows.slot(rows.first(row));
        for (std::size_t i = 0; i < count; ++i) {
            pairs.emplace_back(first, rows.slot(rows.second(i)));
            EXPECT_EQ(rows.geom(rows.second(i)), geomOf(pairs.back().second));
        }
    }
    return pairs;
}

class PairRows : public testing::Test {
protected:
    double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
    bool isOneIn(unsigned n) { return random() % n == 0; }

    // Of many sizes and around zero; some lie in one place, some are infinite, inverted, or of one body.
    std::vector<Thing> draw() {
        std::vector<Thing> things(random() % 60);
        const double room = isOneIn(3) ? 0.5 : isOneIn(2) ? 5 : 20;
        const bool hasOdd = isOneIn(2), hasFilters = isOneIn(2);
        for (Thing &thing : things) {
            const double size = std::ldexp(1.0, static_cast<int>(random() % 6) - 3);
            for (int axis = 0; axis < 3; ++axis) {
                const double low = between(-room, room);
                thing.box.v[2 * axis] = static_cast<dReal>(low);
                thing.box.v[2 * axis + 1] = static_cast<dReal>(low + between(0, size));
            }
            if (hasOdd && isOneIn(12)) thing.box.v[random() % 3 * 2 + 1] = dInfinity;
            if (hasOdd && isOneIn(12)) std::swap(thing.box.v[4], thing.box.v[5]);
            if (!hasFilters) continue;
            thing.filter.category = 1 + random() % 3;
            thing.filter.collide = 1 + random() % 3;
            if (isOneIn(3)) thing.filter.body = reinterpret_cast<const dxBody *>(static_cast<std::uintptr_t>(8 + 8 * (random() % 4)));
        }
        return things;
    }
    static bool agree(const Thing &a, const Thing &b) { return dxFiltersAgree(a.filter, b.filter); }
    static bool meet(const Thing &a, const Thing &b) { return agree(a, b) && a.box.overlaps(b.box); }

    std::mt19937 random{1};
};

TEST_F(PairRows, EachIsPairedWithThoseBehindIt) {
    dxPairRows rows;
    for (int run = 0; run < 500; ++run) {
        const std::vector<Thing> things = draw();
        Pairs expected;
        rows.clear();
        for (std::uint32_t i = 0; i < things.size(); ++i) {
            rows.push(geomOf(i), i, things[i].filter, things[i].box);
            for (std::uint32_t j = i + 1; j < things.size(); ++j)
                if (meet(things[i], things[j])) expected.emplace_back(i, j);
        }
        rows.finish();
        ASSERT_EQ(pairsOf(rows), expected) << run;
        EXPECT_GE(rows.overlaps(), expected.size());
        EXPECT_EQ(rows.comparisons(), things.size() * (things.size() + 1) / 2 - things.size());
    }
}

// As dxHashSpace::collide: a chain for each cell, the newest in front; a bit for each two that have met.
Pairs pairsOfHashSpace(const std::vector<Thing> &things, const std::vector<dxHashCells> &cells) {
    using Key = std::tuple<int, int, int, int, bool>;
    const auto keyOf = [](int level, const dxHashCells::Cell &cell) { return Key(level, cell.x, cell.y, cell.z, cell.isOfColumnBelowZero); };
    std::map<Key, std::vector<std::uint32_t>> stored;
    std::vector<std::uint32_t> table, big;
    int highest = -100;
    for (std::uint32_t i = 0; i < things.size(); ++i) {
        const bool isBig = cells[i].kind() == dxHashCells::Kind::big;
        (isBig ? big : table).push_back(i);
        if (isBig) continue;
        const int level = cells[i].level();
        highest = std::max(highest, level);
        cells[i].forEachCell(level, [&](const dxHashCells::Cell &cell) { stored[keyOf(level, cell)].push_back(i); });
    }
    Pairs pairs;
    std::map<std::pair<std::uint32_t, std::uint32_t>, bool> haveMet;
    const auto tryPair = [&](std::uint32_t a, std::uint32_t b) {
        if (a == b || std::exchange(haveMet[std::minmax(a, b)], true)) return;
        const bool overlap = things[a].box.overlaps(things[b].box);
        if (overlap && dxFiltersAgree(things[a].filter, things[b].filter)) pairs.emplace_back(a, b);
    };
    for (const std::uint32_t searcher : table)
        for (int level = cells[searcher].level(); level <= highest; ++level)
            cells[searcher].forEachCell(level, [&](const dxHashCells::Cell &cell) {
                const auto chain = stored.find(keyOf(level, cell));
                if (chain == stored.end()) return;
                for (auto found = chain->second.rbegin(); found != chain->second.rend(); ++found) tryPair(searcher, *found);
            });
    for (const std::uint32_t a : table)
        for (const std::uint32_t b : big) tryPair(a, b);
    for (std::size_t i = 0; i < big.size(); ++i)
        for (std::size_t j = i + 1; j < big.size(); ++j) tryPair(big[i], big[j]);
    return pairs;
}

TEST_F(PairRows, OfAHashSpaceComeAsFromItsCells) {
    dxHashRows rows;
    std::size_t found = 0;
    for (int run = 0; run < 2000; ++run) {
        const std::vector<Thing> things = draw();
        const dxHashLevels levels{-static_cast<int>(random() % 4), static_cast<int>(random() % 4)};
        std::vector<dxHashCells> cells;
        rows.clear();
        for (std::uint32_t i = 0; i < things.size(); ++i) {
            cells.emplace_back(things[i].box.v, levels);
            rows.push(geomOf(i), i, things[i].filter, things[i].box, cells.back());
        }
        rows.finish();
        const Pairs expected = pairsOfHashSpace(things, cells);
        ASSERT_EQ(pairsOf(rows), expected) << run;
        found += expected.size();
    }
    EXPECT_GT(found, 50000u);
}

TEST_F(PairRows, OfASweepComeInItsOrderAndInfiniteOnesMeetAll) {
    dxSapRows rows;
    for (int run = 0; run < 500; ++run) {
        const std::vector<Thing> things = draw();
        const dxSapAxes axes(dSAP_AXES_XYZ);
        std::vector<std::uint32_t> swept, infinite;
        std::vector<dxSapBox> boxes;
        for (std::uint32_t i = 0; i < things.size(); ++i) {
            const dReal *const v = things[i].box.v;
            boxes.push_back({static_cast<float>(v[0]), static_cast<float>(v[1]), v[2], v[3], v[4], v[5], v[1] == dInfinity});
            (boxes[i].isInfinite ? infinite : swept).push_back(i);
        }
        std::vector<std::uint32_t> sorted = swept, places(swept.size());
        std::stable_sort(sorted.begin(), sorted.end(), [&](std::uint32_t a, std::uint32_t b) { return boxes[a].low < boxes[b].low; });
        for (std::size_t i = 0; i < swept.size(); ++i)
            places[i] = static_cast<std::uint32_t>(std::find(sorted.begin(), sorted.end(), swept[i]) - sorted.begin());
        Pairs expected;
        for (std::size_t i = 0; i < sorted.size(); ++i)
            for (std::size_t j = i + 1; j < sorted.size() && boxes[sorted[j]].low <= boxes[sorted[i]].high; ++j)
                if (boxes[sorted[i]].meetsAcross(boxes[sorted[j]]) && agree(things[sorted[i]], things[sorted[j]]))
                    expected.emplace_back(sorted[i], sorted[j]);
        for (std::size_t i = 0; i < infinite.size(); ++i) {
            for (std::size_t j = i + 1; j < infinite.size(); ++j)
                if (agree(things[infinite[i]], things[infinite[j]])) expected.emplace_back(infinite[i], infinite[j]);
            for (const std::uint32_t other : swept)
                if (agree(things[infinite[i]], things[other])) expected.emplace_back(infinite[i], other);
        }
        rows.clear(sorted.size());
        for (const std::uint32_t thing : sorted) rows.pushSwept(geomOf(thing), thing, things[thing].filter, boxes[thing]);
        for (const std::uint32_t thing : infinite) rows.pushInfinite(geomOf(thing), thing, things[thing].filter);
        for (const std::uint32_t place : places) rows.pushPlace(place);
        rows.finish();
        ASSERT_EQ(pairsOf(rows), expected) << run;
    }
}

}  // namespace
