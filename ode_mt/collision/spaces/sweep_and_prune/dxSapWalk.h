// One call of a sweep-and-prune space, step by step as in upstream: where most geoms move, and where pairs do not follow from boxes alone (there is
// NaN among the keys, or boxes are not up to date). And what such calls leave to later calls (dxSapLastWalk).
//
// Threading: as dxOrderedSpace.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <ode/ode.h>

#include "collision/spaces/dxSpaceGeoms.h"
#include "collision/spaces/sweep_and_prune/dxSapSort.h"
#include "collision/spaces/sweep_and_prune/dxSapState.h"

// Upstream's lists of the geoms that a call sweeps. They belong to its space: a call of dSpaceCollide that is nested in a callback of another one
// fills them again. If a geom has been enabled or disabled, the indices in the outer call's pairs then mean other geoms. Entries behind the end of
// the new lists keep what they had.
class dxSapTemporaryLists {
public:
    // Requires a call at the beginning of each outermost call.
    void restart() { m_fills = 0; }
    bool isFirst() const { return m_fills == 0; }
    // Requires a call by each nested call with its geoms; before the first of these, with those of the call around it.
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

    // Forgets the geoms and pairs of the last call, and reserves memory for a number of geoms.
    void begin(std::size_t geoms);
    // Forgets the geoms and pairs, and frees their memory.
    void freeMemory() { *this = dxSapWalk(m_axes); }
    // Adds a geom. Requires the order of the list, and enabled geoms.
    void add(dxGeom *geom);
    void findPairs(dxSapSort &sort);

    // For a call whose pairs were found without a walk: adds a geom with its box, and finds the pairs along a known order. Requires no NaN among the
    // keys.
    void add(dxGeom *geom, const dxSapBox &box);
    void addInfinite(dxGeom *geom) { m_infinite.push_back(geom); }
    void findPairs(const std::vector<std::uint32_t> &order) { sweep(order); }

    const std::vector<dxGeom *> &swept() const { return m_swept; }
    const std::vector<dxGeom *> &infinite() const { return m_infinite; }
    std::size_t pairs() const { return m_found; }
    // Returns the number of comparisons: each geom with those that begin within its extent on the first axis.
    std::size_t comparisons() const { return m_comparisons; }
    // Calls the callbacks. `fills`: lists.fills() when the call began to deliver. `after`: begins behind this pair; NULL: with the first.
    void deliver(void *data, dNearCallback *callback, const dxSapTemporaryLists &lists, unsigned fills, const dxOrderedPair *after = nullptr);
    // Returns whether deliver() may be called again instead of another walk while no geom is added, removed, moved, enabled or disabled: without NaN
    // among the keys the next sort has the same order.
    bool isRepeatable() const { return !m_hasNaN; }
    // Returns whether the filters excluded no more than half of the pairs that were last delivered.
    bool areMostWanted() const { return 2 * m_wanted >= m_found; }

    // Upstream's assertion.
    static void requireCleanBoxes(const dxGeom *g1, const dxGeom *g2) {
        if (((g1->gflags | g2->gflags) & GEOM_AABB_BAD) != 0) reportUncleanBox((g1->gflags & GEOM_AABB_BAD) != 0);
    }

private:
    struct Pair {
        std::uint32_t earlier, later;  // indices in m_swept
    };

    static void reportUncleanBox(bool isFirst);

    // Requires that no key is NaN.
    void sweep(const std::vector<std::uint32_t> &order);
    void sweepAsUpstream(const std::vector<std::uint32_t> &order);

    dxSapAxes m_axes;
    std::vector<dxGeom *> m_swept, m_infinite;
    std::vector<dxSapBox> m_boxes;   // of m_swept
    std::vector<dxSapBox> m_sorted;  // scratch: the same in order
    std::vector<float> m_keys;
    bool m_hasNaN = false;
    std::vector<Pair> m_pairs;  // those found, and room for more
    std::size_t m_found = 0, m_wanted = 0;
    std::size_t m_comparisons = 0;
};

// The walk of the last outermost call that walked. A call may deliver it again while nothing changes.
class dxSapLastWalk {
public:
    explicit dxSapLastWalk(const dxSapAxes &axes) : m_walk(axes) {}

    dxSapWalk &walk() { return m_walk; }
    // Returns whether no member has been added, removed, moved, enabled or disabled since.
    bool isCurrent(const dxSpaceGeoms &geoms) const { return m_isCurrent && m_switches == geoms.switches(); }
    void setCurrent(const dxSpaceGeoms &geoms) {
        m_isCurrent = true;
        m_switches = geoms.switches();
    }
    void invalidate() { m_isCurrent = false; }
    // Invalidates the walk and frees its memory.
    void discard() {
        m_isCurrent = false;
        m_walk.freeMemory();
    }
    // Returns whether the outermost call in progress delivers it.
    bool isDelivered() const { return m_isDelivered; }
    void noteDelivered() { m_isDelivered = true; }

    // Requires a call at the beginning of each outermost call.
    void beginCall() {
        m_lists.restart();
        m_isDelivered = false;
    }
    dxSapTemporaryLists &lists() { return m_lists; }

    // A walk changes the state of the sort, so kept pairs with equal keys may get another order.
    void noteSorted() { m_hasSorted = true; }
    // Returns whether there was a walk since the last such question.
    bool takeSorted() { return std::exchange(m_hasSorted, false); }

private:
    dxSapWalk m_walk;
    dxSapTemporaryLists m_lists;
    bool m_isCurrent = false, m_isDelivered = false, m_hasSorted = false;
    std::uint64_t m_switches = 0;  // dxSpaceGeoms::switches() when the walk became current
};
