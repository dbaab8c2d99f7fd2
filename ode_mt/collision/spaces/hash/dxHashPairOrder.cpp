#include "collision/spaces/hash/dxHashPairOrder.h"

#include <atomic>

#include "core/dxPrefetch.h"
#include "seams/assertions.h"

namespace {

// Corner of a geom that upstream does not find (dxHashCells::firstSharedCorner).
constexpr std::uint8_t kLost = 8;

constexpr int kCorners = 8;

using Kind = dxHashCells::Kind;

// What upstream compares first, second and last: the highest bits of a primary key.
enum Stage : std::uint64_t { kWithinTable, kTableWithBig, kWithinBig };

std::uint64_t stageAndRank(Stage stage, dxRank rank) {
    constexpr std::uint64_t kRankBits = (UINT64_C(1) << 62) - 1;
    return static_cast<std::uint64_t>(stage) << 62 | (dxFrontFirst(rank) & kRankBits);
}

// Returns an unsigned number that sorts as this signed one does.
std::uint32_t sortable(int number) { return static_cast<std::uint32_t>(number) ^ UINT32_C(0x80000000); }

// Returns two signed numbers in one word that sorts as they do.
std::uint64_t pack(int high, int low) { return static_cast<std::uint64_t>(sortable(high)) << 32 | sortable(low); }

struct Element {
    const dxHashCells &cells;
    dxRank rank;
};

bool isInTable(const Element &element) { return element.cells.kind() == Kind::inTable; }

// Returns whether `a` finds `b`. Of two boxes in the table the one of the lower level finds the other, because a search finds only boxes of its own
// level and of higher ones. On equal levels it is the one further to the front of the list.
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
    key.words[3] = dxBackFirst(found.rank);  // upstream searches a cell from what it stored last
    return true;
}

// Members in a chunk: some ten microseconds of work.
constexpr std::size_t kCellsPerChunk = 512;

// Prefetch distance, in members.
constexpr std::size_t kCellPrefetchDistance = 8;

}  // namespace

// ---- Rows ----------------------------------------------------------------------------------------------------------------------------

void dxHashRows::clear() {
    dxPairRows::clear();
    m_table.clear();
    m_big.clear();
    m_bigBoxes.clear();
    m_byLevel.clear();
}

void dxHashRows::push(dxGeom *geom, Slot slot, const dxPairFilter &filter, const dxBounds &box, const dxHashCells &cells) {
    const bool isBig = cells.kind() == dxHashCells::Kind::big;
    if (!isBig) m_byLevel.push_back({sortable(cells.level()), static_cast<std::uint32_t>(m_table.size())});
    (isBig ? m_big : m_table).push_back({geom, slot, filter, box, cells});
}

void dxHashRows::finish() {
    dxRadixSort(m_byLevel, m_spare);
    m_cells.clear();
    m_listed.resize(m_table.size());
    for (const dxSortItem &item : m_byLevel) {
        const Pushed &pushed = m_table[item.index];
        m_listed[item.index] = static_cast<std::uint32_t>(m_cells.size());
        m_cells.push_back(pushed.cells);
        dxPairRows::push(pushed.geom, pushed.slot, pushed.filter, pushed.box);
    }
    for (const Pushed &pushed : m_big) {
        pushElement(pushed.geom, pushed.slot, pushed.filter);
        m_bigBoxes.push(pushed.box);
    }
    dxPairRows::finish();
    m_ordered.resize(m_found.size());
    m_corners.resize(m_found.size());
}

std::size_t dxHashRows::find(std::size_t row) {
    const std::size_t table = m_listed.size(), element = first(row);
    if (row < table) return findInTable(element);
    if (row < 2 * table) return findBig(0, box(element), element);
    return findBig(element - table + 1, m_bigBoxes.row(element - table), element);
}

std::size_t dxHashRows::findBig(std::size_t begin, const dxBounds &box, std::size_t element) {
    const std::size_t count = findFrom(begin, m_bigBoxes, box);
    for (std::size_t i = 0; i < count; ++i) m_found[i] += static_cast<std::uint32_t>(m_listed.size());
    return keepAgreeing(element, count);
}

std::size_t dxHashRows::findInTable(std::size_t searcher) {
    const std::size_t overlapping = findFrom(searcher + 1, m_boxes, box(searcher));
    return orderByCells(m_cells[searcher], keepAgreeing(searcher, overlapping));
}

std::size_t dxHashRows::orderByCells(const dxHashCells &searcher, std::size_t count) {
    std::size_t ordered = 0;
    for (std::size_t begin = 0; begin < count;) {
        const int level = m_cells[m_found[begin]].level();
        std::size_t end = begin + 1;
        while (end < count && m_cells[m_found[end]].level() == level) ++end;
        ordered = orderLevel(searcher, begin, end, ordered);
        begin = end;
    }
    m_found.swap(m_ordered);
    return ordered;
}

// Sorts the geoms found on one level by cell: a counting sort that goes from back to front, so that geoms with equal cells are reversed. Returns
// the place behind the last one.
std::size_t dxHashRows::orderLevel(const dxHashCells &searcher, std::size_t begin, std::size_t end, std::size_t to) {
    std::size_t counts[kCorners + 1] = {};
    for (std::size_t i = begin; i < end; ++i) {
        unsigned corner = kLost;
        if (!dxHashCells::firstSharedCorner(searcher, m_cells[m_found[i]], corner)) corner = kLost;
        m_corners[i] = static_cast<std::uint8_t>(corner);
        ++counts[corner];
    }
    std::size_t places[kCorners + 1];
    for (int corner = 0; corner <= kCorners; ++corner) {
        places[corner] = to;
        to += counts[corner];
    }
    for (std::size_t i = end; i-- > begin;) m_ordered[places[m_corners[i]]++] = m_found[i];
    return to - counts[kLost];
}

// ---- Kept pairs ----------------------------------------------------------------------------------------------------------------------

void dxHashPairOrder::update(std::vector<dxOrderedPair> &pairs, dxPairWork &work) {
    updateCells();
    m_pairs.updateSorted(pairs, work);
}

dxPairRows &dxHashPairOrder::gatherRows() {
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

void dxHashPairOrder::updateCells() {
    m_cells.resize(m_geoms.members().end());
    const std::vector<Slot> &changed = m_geoms.members().changed();
    std::atomic<int> outOfRange{0};  // increase of their number
    m_geoms.runner().forChunks(dxParallelStage::Boxes, changed.size(), kCellsPerChunk, [&](std::size_t begin, std::size_t end, unsigned) {
        int ofChunk = 0;
        for (std::size_t i = begin; i < end; ++i) {
            if (i + kCellPrefetchDistance < end) prefetch(changed[i + kCellPrefetchDistance]);
            ofChunk += updateCellsOf(changed[i]);
        }
        if (ofChunk != 0) outOfRange.fetch_add(ofChunk, std::memory_order_relaxed);
    });
    m_outOfRange += outOfRange.load(std::memory_order_relaxed);
}

// Returns by how many the number of members out of range increases.
int dxHashPairOrder::updateCellsOf(Slot slot) {
    dxHashCells &cells = m_cells[slot];
    const bool wasOut = cells.kind() == Kind::outOfRange;
    const dxMembers::Member &member = m_geoms.members()[slot];
    cells = member.geom != nullptr ? dxHashCells(member.bounds.v, m_levels) : dxHashCells();
    return (cells.kind() == Kind::outOfRange) - wasOut;
}

bool dxHashPairOrder::primaryKey(Slot a, Slot b, std::uint64_t &word, bool &swapped) const {
    const Element elementA{m_cells[a], m_geoms.members()[a].rank}, elementB{m_cells[b], m_geoms.members()[b].rank};
    if (elementA.cells.kind() == Kind::outOfRange || elementB.cells.kind() == Kind::outOfRange) return false;
    swapped = !isSearcher(elementA, elementB);
    word = swapped ? primaryKeyOf(elementB, elementA) : primaryKeyOf(elementA, elementB);
    return true;
}

bool dxHashPairOrder::secondaryKey(Slot first, Slot second, dxPairKey &key) const {
    return secondaryKeysOf({m_cells[first], m_geoms.members()[first].rank}, {m_cells[second], m_geoms.members()[second].rank}, key);
}

void dxHashPairOrder::prefetch(Slot slot) const {
    m_geoms.members().prefetch(slot);
    dxPrefetch::line(&m_cells[slot]);
}

bool dxHashPairOrder::requireValid() const {
    if (m_outOfRange == 0) return false;
    for (const dxGeom *geom = m_geoms.space().first; geom != nullptr; geom = geom->next)
        if (dxGeomIsEnabled(geom) && m_cells[dxSpaceGeoms::slotOf(geom)].kind() == Kind::outOfRange) reportOutOfRange();
    return true;
}

void dxHashPairOrder::reportOutOfRange() {
    dxFailUpstreamAssertion("aabbBound >= dMinIntExact && aabbBound < dMaxIntExact", "collide", "collision_space.cpp", kHashSpaceRangeLine);
}
