// dxQuadRows against a comparison of every two boxes.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>

#include "collision/spaces/quad_tree/dxQuadTreePairOrder.h"

namespace {

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

struct Scene {
    const char *name;
    int depth;
    double spread, size;  // of places, of boxes
    bool isSpread = false;  // over many blocks
};
void PrintTo(const Scene &scene, std::ostream *out) { *out << scene.name; }

class QuadRows : public testing::TestWithParam<Scene> {
protected:
    struct Geom {
        dxBounds box;
        dxQuadTree::Block block;
    };

    std::vector<Geom> make(const dxQuadTree &tree, std::size_t count) {
        std::uniform_real_distribution<double> place(-GetParam().spread, GetParam().spread), size(0, GetParam().size);
        std::vector<Geom> geoms(count);
        for (Geom &geom : geoms) {
            for (int axis = 0; axis < 3; ++axis) {
                const double low = place(m_random);
                geom.box.v[2 * axis] = static_cast<dReal>(low);
                geom.box.v[2 * axis + 1] = static_cast<dReal>(low + size(m_random));
            }
            geom.block = tree.find(geom.box.v, dxQuadTree::kRoot);
        }
        std::stable_sort(geoms.begin(), geoms.end(), [](const Geom &a, const Geom &b) { return a.block < b.block; });
        return geoms;
    }

    std::mt19937 m_random{1};
};

Pairs findAll(dxQuadRows &rows) {
    Pairs pairs;
    for (std::size_t row = 0; row < rows.rows(); ++row) {
        const std::size_t found = rows.find(row);
        for (std::size_t i = 0; i < found; ++i) pairs.emplace_back(row, rows.second(i));
    }
    return pairs;
}

TEST_P(QuadRows, FindAllPairsInOrderAndCompareNoMoreThanTheBlocksAsk) {
    const dVector3 centre = {0, 0, 0, 0}, extents = {10, 10, 10, 0};
    const dxQuadTree tree(centre, extents, GetParam().depth);
    dxQuadRows rows(tree);
    std::size_t comparisons = 0, all = 0;
    for (const std::size_t count : {0, 1, 2, 7, 60, 300, 40}) {
        const std::vector<Geom> geoms = make(tree, count);
        rows.clear(count);
        for (const Geom &geom : geoms) rows.push(nullptr, 0, {}, geom.box, geom.block);
        rows.finish();
        Pairs expected;
        std::size_t within = 0;
        for (std::size_t a = 0; a < count; ++a)
            for (std::size_t b = a + 1; b < count; ++b) {
                within += geoms[b].block < tree.endOf(geoms[a].block);
                if (geoms[a].box.overlaps(geoms[b].box)) expected.emplace_back(a, b);
            }
        ASSERT_EQ(findAll(rows), expected) << count << " geoms";
        ASSERT_EQ(rows.comparisons(), within) << count << " geoms";
        ASSERT_EQ(rows.candidates(), within) << count << " geoms";
        comparisons += within;
        all += count * count / 2;
    }
    if (GetParam().isSpread) {
        EXPECT_LT(comparisons, all / 2) << "blocks save comparisons";
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, QuadRows,
                         testing::Values(Scene{"OneBlock", 0, 8, 3}, Scene{"Deep", 5, 8, 1, true}, Scene{"LargeBoxes", 4, 8, 9},
                                         Scene{"BeyondTheTree", 3, 20, 4}, Scene{"InOnePlace", 3, 0.01, 1}),
                         [](const auto &info) { return std::string(info.param.name); });

}  // namespace
