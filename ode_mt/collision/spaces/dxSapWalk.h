// One call of a sweep-and-prune space, step by step as in upstream: where most geoms move, and for the cases in which pairs do not follow
// from boxes alone (NaN among the numbers that are sorted, boxes that are not up to date).
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "collision/spaces/dxSapBox.h"
#include "collision/spaces/dxSapSort.h"

struct dxOrderedPair;

// Upstream's lists of the geoms that a call goes through, which are its space's: a call of dSpaceCollide in a callback of another one fills them
// anew, if a geom has been enabled or disabled, and the numbers of the other's pairs then mean other geoms. What the new lists do not reach
// stays in memory as it was.
class dxSapTemporaryLists {
public:
    // Requires a call at the beginning of each call that none is around.
    void restart() { m_fills = 0; }
    bool isFirst() const { return m_fills == 0; }
    // A call within another one has lists of its own. Before the first, with those of the call around it.
    void fill(const std::vector<dxGeom *> &swept, const std::vector<dxGeom *> &infinite) {
        overwrite(m_swept, swept);
        overwrite(m_infinite, infinite);
        m_sweptSize = swept.size();
        m_infiniteSize = infinite.size();
        ++m_fills;
    }

    unsigned fills() const { return m_fills; }
    dxGeom *const *swept() const { return m_swept.data(); }
    dxGeom *const *infinite() const { return m_infinite.data(); }
    std::size_t sweptSize() const { return m_sweptSize; }
    std::size_t infiniteSize() const { return m_infiniteSize; }

private:
    static void overwrite(std::vector<dxGeom *> &list, const std::vector<dxGeom *> &geoms) {
        if (list.size() < geoms.size()) list.resize(geoms.size());
        std::copy(geoms.begin(), geoms.end(), list.begin());
    }

    unsigned m_fills = 0;
    std::vector<dxGeom *> m_swept, m_infinite;
    std::size_t m_sweptSize = 0, m_infiniteSize = 0;
};

class dxSapWalk {
public:
    explicit dxSapWalk(const dxSapAxes &axes) : m_axes(axes) {}

    // Forgets the geoms and pairs of the last call, and makes room for so many geoms.
    void begin(std::size_t geoms);
    // Adds a geom. Requires the order of the list and enabled geoms.
    void add(dxGeom *geom);
    void findPairs(dxSapSort &sort);
    // For a call whose pairs have been found elsewhere: adds a geom with its box, and finds the pairs along an order that is known.
    void add(dxGeom *geom, const dxSapBox &box);
    void addInfinite(dxGeom *geom) { m_infinite.push_back(geom); }
    // Requires no NaN among the keys.
    void findPairs(const std::vector<std::uint32_t> &order) { sweep(order); }
    const std::vector<dxGeom *> &swept() const { return m_swept; }
    const std::vector<dxGeom *> &infinite() const { return m_infinite; }
    std::size_t pairs() const { return m_found; }
    // Returns how many geoms began within the extent of others.
    std::size_t comparisons() const { return m_comparisons; }
    // `fills`: lists.fills() when the call began to deliver. `after`: only what comes behind this pair.
    void deliver(void *data, dNearCallback *callback, const dxSapTemporaryLists &lists, unsigned fills, const dxOrderedPair *after = nullptr);
    // Returns whether deliver() may be called again instead of another walk, as long as no geom comes, goes, moves, is enabled or disabled: of keys
    // without NaN the next sort has the same order.
    bool isRepeatable() const { return !m_hasNaN; }
    // Returns whether the filters excluded no more than half of the pairs that were last delivered.
    bool areMostWanted() const { return 2 * m_wanted >= m_found; }

    // Upstream's assertions.
    static void requireUnlocked(const dxSpace &space);
    static void requireCleanBoxes(const dxGeom *g1, const dxGeom *g2) {
        if (((g1->gflags | g2->gflags) & GEOM_AABB_BAD) != 0) reportUncleanBox((g1->gflags & GEOM_AABB_BAD) != 0);
    }

private:
    struct Pair {
        std::uint32_t earlier, later;
    };

    static void reportUncleanBox(bool isFirst);
    // Delivers one pair as upstream does. Returns whether bits and bodies let it pass.
    static bool deliverPair(dxGeom *first, dxGeom *second, void *data, dNearCallback *callback);

    // Requires that no key is NaN.
    void sweep(const std::vector<std::uint32_t> &order);
    void sweepAsUpstream(const std::vector<std::uint32_t> &order);

    dxSapAxes m_axes;
    std::vector<dxGeom *> m_swept, m_infinite;
    std::vector<dxSapBox> m_boxes;  // of m_swept
    std::vector<dxSapBox> m_sorted;  // scratch: the same in order
    std::vector<float> m_keys;
    bool m_hasNaN = false;
    std::vector<Pair> m_pairs;  // those found, and room for more
    std::size_t m_found = 0, m_wanted = 0;
    std::size_t m_comparisons = 0;
};
