#include "collision/spaces/hash/dxOrderedHashSpace.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "collision/pairs/dxPairPrefetch.h"
#include "collision/spaces/dxPairDelivery.h"
#include "core/dxNoIndex.h"

#include "util.h"

namespace {

using Kind = dxHashCells::Kind;

// One call of a hash space, cell by cell as in upstream: for calls that are nested in another one or continue after an assertion, for boxes that are
// not up to date, and where memory for pairs is missing.
//
// It needs memory for the geoms and for the cells that they cover, at most eight each. (Upstream also keeps a bit for every two geoms.)
class CellWalk {
public:
    // Adds a geom. Requires the order of the list, and no geom out of range.
    void add(dxGeom *geom, const dxHashCells &cells);
    // Allocates the memory of deliver(). Requires a call after the last geom.
    void storeAll();
    // Calls the callbacks, from the first pair on or from behind a pair. Geoms that callbacks add to the space are
    // ignored.
    void deliver(void *data, dNearCallback *callback, const dxOrderedPair *after);

private:
    using Cell = dxHashCells::Cell;

    struct Boxed {
        dxGeom *geom;
        dxHashCells cells;
    };
    struct StoredCell {
        Cell cell;
        int level;
        std::uint32_t last;    // the node stored last in it
        std::uint32_t before;  // the cell stored before it in the same bucket
    };
    struct Node {
        std::uint32_t boxed;
        std::uint32_t before;  // the node stored before it in the same cell
    };
    // Tests two geoms as upstream's collideAABBs does, and calls back if they pass. With `after`, it begins behind that pair.
    struct Meeting {
        void *data;
        dNearCallback *callback;
        const dxOrderedPair *after;

        void meet(dxGeom *first, dxGeom *second) {
            if (after == nullptr)
                dxCollideBoxes(first, second, data, callback);
            else if (first == after->first && second == after->second)
                after = nullptr;
        }
    };

    void store(std::uint32_t boxed, const Cell &cell);
    std::uint32_t find(const Cell &cell, int level) const;
    std::size_t bucketOf(const Cell &cell, int level) const;
    void search(std::uint32_t searcher, Meeting &meeting);

    std::vector<Boxed> m_inTable;
    std::vector<std::uint32_t> m_foundBy;  // by place in m_inTable: the searcher that found the geom last
    std::vector<dxGeom *> m_big;
    std::vector<StoredCell> m_cells;
    std::vector<Node> m_nodes;
    std::vector<std::uint32_t> m_buckets;  // by hash: the cell stored last
    int m_highestLevel = 0;
};

void CellWalk::add(dxGeom *geom, const dxHashCells &cells) {
    if (cells.kind() == dxHashCells::Kind::big) {
        m_big.push_back(geom);
        return;
    }
    m_highestLevel = m_inTable.empty() ? cells.level() : std::max(m_highestLevel, cells.level());
    m_inTable.push_back({geom, cells});
}

void CellWalk::deliver(void *data, dNearCallback *callback, const dxOrderedPair *after) {
    Meeting meeting{data, callback, after};
    for (std::uint32_t searcher = 0; searcher < m_inTable.size(); ++searcher) search(searcher, meeting);
    for (const Boxed &boxed : m_inTable)
        for (dxGeom *const big : m_big) meeting.meet(boxed.geom, big);
    for (std::size_t i = 0; i < m_big.size(); ++i)
        for (std::size_t j = i + 1; j < m_big.size(); ++j) meeting.meet(m_big[i], m_big[j]);
}

// There are twice as many buckets as cells, so few buckets hold more than one cell.
void CellWalk::storeAll() {
    m_foundBy.assign(m_inTable.size(), kNoIndex);
    std::size_t cells = 0, buckets = 1;
    for (const Boxed &boxed : m_inTable)
        boxed.cells.forEachCell(boxed.cells.level(), [&](const Cell &) { ++cells; });
    while (buckets < 2 * cells) buckets *= 2;
    m_buckets.assign(buckets, kNoIndex);
    m_nodes.reserve(cells);
    for (std::uint32_t boxed = 0; boxed < m_inTable.size(); ++boxed) {
        const dxHashCells &own = m_inTable[boxed].cells;
        own.forEachCell(own.level(), [&](const Cell &cell) { store(boxed, cell); });
    }
}

void CellWalk::store(std::uint32_t boxed, const Cell &cell) {
    const int level = m_inTable[boxed].cells.level();
    std::uint32_t number = find(cell, level);
    if (number == kNoIndex) {
        std::uint32_t &bucket = m_buckets[bucketOf(cell, level)];
        number = static_cast<std::uint32_t>(m_cells.size());
        m_cells.push_back({cell, level, kNoIndex, bucket});
        bucket = number;
    }
    m_nodes.push_back({boxed, m_cells[number].last});
    m_cells[number].last = static_cast<std::uint32_t>(m_nodes.size() - 1);
}

std::uint32_t CellWalk::find(const Cell &cell, int level) const {
    std::uint32_t number = m_buckets[bucketOf(cell, level)];
    while (number != kNoIndex && !(m_cells[number].level == level && m_cells[number].cell == cell))
        number = m_cells[number].before;
    return number;
}

std::size_t CellWalk::bucketOf(const Cell &cell, int level) const {
    const auto word = [](int value) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(value)); };
    std::uint64_t mixed = (word(cell.x) << 32 | word(cell.y)) * UINT64_C(0x9e3779b97f4a7c15);
    mixed = ((mixed ^ mixed >> 32) + (word(cell.z) << 32 | word(level))) * UINT64_C(0xc2b2ae3d27d4eb4f);
    return static_cast<std::size_t>(mixed >> 32) & (m_buckets.size() - 1);
}

// A geom searches its own level and those above. In a cell, what was stored last is met first. Of two geoms on one level the one further to the front
// of the list finds the other. So in a cell of its own level the search ends at the geom itself: all that follow are further to the front.
void CellWalk::search(std::uint32_t searcher, Meeting &meeting) {
    const Boxed &own = m_inTable[searcher];
    for (int level = own.cells.level(); level <= m_highestLevel; ++level) {
        const bool isOwnLevel = level == own.cells.level();
        own.cells.forEachCell(level, [&](const Cell &cell) {
            const std::uint32_t number = find(cell, level);
            if (number == kNoIndex) return;
            for (std::uint32_t at = m_cells[number].last; at != kNoIndex; at = m_nodes[at].before) {
                const std::uint32_t found = m_nodes[at].boxed;
                if (isOwnLevel && found <= searcher) return;
                if (m_foundBy[found] == searcher) continue;
                m_foundBy[found] = searcher;
                meeting.meet(own.geom, m_inTable[found].geom);
            }
        });
    }
}

}  // namespace

// Upstream does not even clean a lone geom.
void dxOrderedHashSpace::collide(void *data, dNearCallback *callback) {
    dAASSERT(callback);
    if (count >= 2) dxOrderedSpace::collide(data, callback);
}

// Upstream tests which geoms are enabled before the first callback, and not again. So callbacks may enable and disable geoms.
void dxHashWalker::deliver(void *data, dNearCallback *callback) {
    const std::vector<dxOrderedPair> &pairs = m_space.pairs();
    dxNarrowphasePrefetch *const prefetch = m_space.activePrefetch();
    const std::uint64_t missed = dxMissedNotifications.count();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (prefetch != nullptr) prefetch->beforePair(pairs, i);
        dxPairPrefetch::forCallback(pairs, i);
        dxDeliver(pairs[i], data, callback);
        if (dxMissedNotifications.count() == missed) continue;
        const dxOrderedPair last = pairs[i];
        return walk(data, callback, &last);
    }
}

// Like deliver(), regardless of which geoms callbacks enable or disable.
void dxHashWalker::deliverAnew(void *data, dNearCallback *callback) {
    m_space.geoms().beforeCallbacks([this] { m_order.gatherRows(); });
    const std::uint64_t missed = dxMissedNotifications.count();
    dxForPairsOf(m_order.rows(), m_space.foundPairs(), [](const dxGeom *) { return true; }, [&](const dxOrderedPair &pair) {
        dxDeliver(pair, data, callback);
        if (dxMissedNotifications.count() == missed) return true;
        walk(data, callback, &pair);
        return false;
    });
}

// Upstream tests all pairs that share a cell; where their boxes are not up to date its assertions fail, whether or not the boxes overlap. It puts the
// boxes of the enabled geoms into cells before the first callback. So the rest of a call, behind a pair, has the cells of that call's beginning.
void dxHashWalker::walk(void *data, dNearCallback *callback, const dxOrderedPair *after) {
    CellWalk walk;
    m_space.geoms().beforeCallbacks([&] {
        for (dxGeom *geom = m_space.first; geom != nullptr; geom = geom->next) {
            if (after == nullptr && !dxGeomIsEnabled(geom)) continue;
            const dxHashCells cells = after != nullptr ? m_order.cellsOf(dxSpaceGeoms::slotOf(geom)) : dxHashCells(geom->aabb, m_order.levels());
            if (cells.kind() == Kind::none) continue;
            if (cells.kind() == Kind::outOfRange) dxHashPairOrder::reportOutOfRange();
            walk.add(geom, cells);
        }
        walk.storeAll();
    });
    walk.deliver(data, callback, after);
}
