// The order of pairs of hash spaces: each geom finds others in the cells that it covers, on its own level and on those above; pairs with geoms too
// large for any level follow. docs/collision.md.
//
// Kept pairs are ordered by keys (dxHashPairOrder). Where all pairs are found anew, they are found in this order (dxHashRows).
// Threading: as dxOrderedSpace.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "collision/broadphase/dxPairRows.h"
#include "collision/spaces/dxSpaceGeoms.h"
#include "collision/spaces/dxSpacePairs.h"
#include "collision/spaces/dxSpaceParts.h"
#include "collision/spaces/hash/dxHashCells.h"
#include "core/dxRadixSort.h"

// All pairs of a hash space, found anew with SIMD, in upstream's order.
//
// Geoms in the table are sorted by level, and within a level by their place in the list: what a geom finds is behind it. What it finds on one level
// is ordered by the first cell that both cover; within a cell the geom furthest to the back of the list is first. A box covers at most two cells
// along an axis, so there are at most eight such cells.
class dxHashRows final : public dxPairRows {
public:
    // These three replace those of the base, because a geom has cells, too. push() requires the order of the list, and no geom out of range.
    void clear();
    void push(dxGeom *geom, Slot slot, const dxPairFilter &filter, const dxBounds &box, const dxHashCells &cells);
    void finish();

    // Each geom in the table with those that it finds, front first; then each with the big ones; then the big ones among themselves.
    std::size_t rows() const override { return m_big.empty() ? m_listed.size() : 2 * m_listed.size() + m_big.size(); }
    std::size_t first(std::size_t row) const override {
        const std::size_t table = m_listed.size();
        return row < table ? m_listed[row] : row < 2 * table ? m_listed[row - table] : row - table;
    }
    std::size_t find(std::size_t row) override;

private:
    struct Pushed {
        dxGeom *geom;
        Slot slot;
        dxPairFilter filter;
        dxBounds box;
        dxHashCells cells;
    };

    std::size_t findInTable(std::size_t searcher);
    std::size_t findBig(std::size_t begin, const dxBounds &box, std::size_t element);
    std::size_t orderByCells(const dxHashCells &searcher, std::size_t count);
    std::size_t orderLevel(const dxHashCells &searcher, std::size_t begin, std::size_t end, std::size_t to);

    std::vector<Pushed> m_table, m_big;  // in the order of the list
    std::vector<dxSortItem> m_byLevel, m_spare;
    std::vector<std::uint32_t> m_listed;  // elements in the table, in the order of the list
    std::vector<dxHashCells> m_cells;     // by element
    dxBoxColumns m_bigBoxes;
    std::vector<std::uint32_t> m_ordered;  // scratch of a row
    std::vector<std::uint8_t> m_corners;   // by place in m_found
};

class dxHashPairOrder final : public dxSpacePairOrder {
public:
    using Slot = dxMembers::Slot;

    dxHashPairOrder(dxSpaceGeoms &geoms, dxSpacePairs &pairs) : m_geoms(geoms), m_pairs(pairs) {}

    // A callback may call this. As in upstream, the levels take effect at the next call of dSpaceCollide; pairs stay as they are until then.
    void setLevels(const dxHashLevels &levels) {
        m_levels = levels;
        m_pairs.outdate();
    }
    const dxHashLevels &levels() const { return m_levels; }
    // Returns the cells of a member as of the last call.
    const dxHashCells &cellsOf(Slot slot) const { return m_cells[slot]; }
    dxHashRows &rows() { return m_rows; }

    void update(std::vector<dxOrderedPair> &pairs, dxPairWork &work) override;
    dxPairRows &gatherRows() override;
    // Raises upstream's assertion if an enabled geom is out of range.
    bool requireValid() const override;
    static void reportOutOfRange();

    bool primaryKey(Slot a, Slot b, std::uint64_t &word, bool &swapped) const override;
    bool secondaryKey(Slot first, Slot second, dxPairKey &key) const override;
    void prefetch(Slot slot) const override;

private:
    void updateCells();
    int updateCellsOf(Slot slot);

    dxSpaceGeoms &m_geoms;
    dxSpacePairs &m_pairs;
    dxHashLevels m_levels{-3, 10};     // upstream's defaults
    std::vector<dxHashCells> m_cells;  // by slot; none: the member was not enabled when the outermost call began
    int m_outOfRange = 0;              // number of members whose cells are out of range
    dxHashRows m_rows;
};
