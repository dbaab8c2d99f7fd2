#include "collision/spaces/dxOrderedHashSpace.h"

#include <atomic>

#include "collision/pairs/dxPairPrefetch.h"
#include "collision/spaces/dxHashWalk.h"
#include "collision/spaces/dxPairDelivery.h"
#include "collision/spaces/dxUpstreamAssertion.h"
#include "core/dxPrefetch.h"
#include "seams/assertions.h"

#include "collision_space_internal.h"
#include "util.h"

namespace {

using Kind = dxHashCells::Kind;

// Words of a key: what upstream compares first, second and last.
enum Stage : std::uint64_t { kWithinTable, kTableWithBig, kWithinBig };

std::uint64_t stageAndRank(Stage stage, dxRank rank) {
    constexpr std::uint64_t kRankBits = (UINT64_C(1) << 62) - 1;
    return static_cast<std::uint64_t>(stage) << 62 | (dxFrontFirst(rank) & kRankBits);
}

// Two signed numbers in one word that sorts as they do.
std::uint64_t pack(int high, int low) {
    const auto biased = [](int i) { return static_cast<std::uint32_t>(i) ^ UINT32_C(0x80000000); };
    return static_cast<std::uint64_t>(biased(high)) << 32 | biased(low);
}

struct Element {
    const dxHashCells &cells;
    dxRank rank;
};

bool isInTable(const Element &element) { return element.cells.kind() == Kind::inTable; }

// Of two boxes in the table the one of the lower level finds the other, because a search finds only boxes of its own
// level and of higher ones. Of two equal ones it is the one further to the front of the list.
bool isSearcher(const Element &a, const Element &b) {
    if (isInTable(a) != isInTable(b)) return isInTable(a);
    if (isInTable(a) && a.cells.level() != b.cells.level()) return a.cells.level() < b.cells.level();
    return a.rank > b.rank;
}

std::uint64_t primaryKeyOf(const Element &searcher, const Element &found) {
    const Stage stage = isInTable(found) ? kWithinTable : isInTable(searcher) ? kTableWithBig : kWithinBig;
    return stageAndRank(stage, searcher.rank);
}

bool secondaryKeysOf(const Element &searcher, const Element &found, dxPairKey &key) {
    if (!isInTable(found)) {
        key.words[1] = key.words[2] = 0;
        key.words[3] = dxFrontFirst(found.rank);
        return true;
    }
    dxHashCells::Cell cell;
    if (!dxHashCells::firstSharedCell(searcher.cells, found.cells, cell)) return false;
    key.words[1] = pack(found.cells.level(), cell.x);
    key.words[2] = pack(cell.y, cell.z);
    key.words[3] = dxBackFirst(found.rank);  // within a cell upstream finds first what it stored last
    return true;
}

// What one worker takes at once: some ten microseconds.
constexpr std::size_t kCellsPerChunk = 512, kCellPrefetchDistance = 8;

void reportOutOfRange() {
    dxFailUpstreamAssertion("aabbBound >= dMinIntExact && aabbBound < dMaxIntExact", "collide", "collision_space.cpp", kHashSpaceRangeLine);
}

}  // namespace

// Upstream does not even clean a lone geom.
void dxOrderedHashSpace::collide(void *data, dNearCallback *callback) {
    dAASSERT(callback);
    if (count >= 2) dxOrderedSpace::collide(data, callback);
}

void dxCellPairOrder::update(std::vector<dxOrderedPair> &pairs, dxPairWork &work) {
    updateCells();
    m_pairs.updateSorted(pairs, work);
}

dxPairRows &dxCellPairOrder::gatherRows() {
    updateCells();
    requireValid();
    m_rows.clear();
    for (dxGeom *geom = m_geoms.space().first; geom != nullptr; geom = geom->next) {
        const Slot slot = dxSpaceGeoms::slotOf(geom);
        const dxMembers::Member &member = m_geoms.members()[slot];
        if (member.geom != nullptr) m_rows.push(geom, slot, member.filter, member.bounds, m_cells[slot]);
    }
    m_rows.finish();
    return m_rows;
}

void dxCellPairOrder::updateCells() {
    m_cells.resize(m_geoms.members().end());
    const std::vector<Slot> &changed = m_geoms.members().changed();
    std::atomic<int> more{0};  // out of range
    m_geoms.runner().forChunks(dxParallelStage::Boxes, changed.size(), kCellsPerChunk, [&](std::size_t begin, std::size_t end, unsigned) {
        int moreHere = 0;
        for (std::size_t i = begin; i < end; ++i) {
            if (i + kCellPrefetchDistance < end) prefetch(changed[i + kCellPrefetchDistance]);
            moreHere += updateCellsOf(changed[i]);
        }
        if (moreHere != 0) more.fetch_add(moreHere, std::memory_order_relaxed);
    });
    m_outOfRange += more.load(std::memory_order_relaxed);
}

// Returns by how many more members are out of range.
int dxCellPairOrder::updateCellsOf(Slot slot) {
    dxHashCells &cells = m_cells[slot];
    const bool wasOut = cells.kind() == Kind::outOfRange;
    const dxMembers::Member &member = m_geoms.members()[slot];
    cells = member.geom != nullptr ? dxHashCells(member.bounds.v, m_levels) : dxHashCells();
    return (cells.kind() == Kind::outOfRange) - wasOut;
}

bool dxCellPairOrder::primaryKey(Slot a, Slot b, std::uint64_t &word, bool &swapped) const {
    const Element elementA{m_cells[a], m_geoms.members()[a].rank}, elementB{m_cells[b], m_geoms.members()[b].rank};
    if (elementA.cells.kind() == Kind::outOfRange || elementB.cells.kind() == Kind::outOfRange) return false;
    swapped = !isSearcher(elementA, elementB);
    word = swapped ? primaryKeyOf(elementB, elementA) : primaryKeyOf(elementA, elementB);
    return true;
}

bool dxCellPairOrder::secondaryKey(Slot first, Slot second, dxPairKey &key) const {
    return secondaryKeysOf({m_cells[first], m_geoms.members()[first].rank}, {m_cells[second], m_geoms.members()[second].rank},
                      key);
}

void dxCellPairOrder::prefetch(Slot slot) const {
    m_geoms.members().prefetch(slot);
    dxPrefetch::line(&m_cells[slot]);
}

bool dxCellPairOrder::requireValid() const {
    if (m_outOfRange == 0) return false;
    for (const dxGeom *geom = m_geoms.space().first; geom != nullptr; geom = geom->next)
        if (dxGeomIsEnabled(geom) && m_cells[dxSpaceGeoms::slotOf(geom)].kind() == Kind::outOfRange) reportOutOfRange();
    return true;
}

// Upstream tests which geoms are enabled before the first callback, and not again.
void dxCellWalker::deliver(void *data, dNearCallback *callback) {
    const std::vector<dxOrderedPair> &pairs = m_space.pairs();  // of those
    dxNarrowphasePrefetch *const ahead = m_space.ahead();
    const std::uint64_t missed = dxMissedNotifications.count();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (ahead != nullptr) ahead->beforePair(pairs, i);
        dxPairPrefetch::forCallback(pairs, i);
        dxDeliver(pairs[i], data, callback);
        if (dxMissedNotifications.count() == missed) continue;
        const dxOrderedPair last = pairs[i];
        return walk(data, callback, &last);
    }
}

// As deliver().
void dxCellWalker::deliverAnew(void *data, dNearCallback *callback) {
    m_space.geoms().beforeCallbacks([this] { m_order.gatherRows(); });
    const std::uint64_t missed = dxMissedNotifications.count();
    dxForPairsOf(m_order.rows(), m_space.foundPairs(), [](const dxGeom *) { return true; }, [&](const dxOrderedPair &pair) {
        dxDeliver(pair, data, callback);
        if (dxMissedNotifications.count() == missed) return true;
        walk(data, callback, &pair);
        return false;
    });
}

// All pairs that share a cell, whether or not their boxes overlap, for the assertions in collideAABBs.
// Upstream puts the boxes of geoms that are enabled into cells before the first callback; behind a pair they are those of the call that met it.
void dxCellWalker::walk(void *data, dNearCallback *callback, const dxOrderedPair *after) {
    dxHashWalk walk;
    m_space.geoms().beforeCallbacks([&] {
        for (dxGeom *geom = m_space.first; geom != nullptr; geom = geom->next) {
            if (after == nullptr && !dxGeomIsEnabled(geom)) continue;
            const dxHashCells cells = after != nullptr ? m_order.cellsOf(dxSpaceGeoms::slotOf(geom)) : dxHashCells(geom->aabb, m_order.levels());
            if (cells.kind() == Kind::none) continue;
            if (cells.kind() == Kind::outOfRange) reportOutOfRange();
            walk.add(geom, cells);
        }
        walk.storeAll();
    });
    walk.deliver(data, callback, after);
}
