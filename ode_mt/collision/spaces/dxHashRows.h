// All pairs of a hash space, found anew with SIMD, in upstream's order (docs/collision.md).
//
// The geoms of the table are sorted by level, those of one level as in the list: what a geom finds is behind it. Those that it finds
// on one level are ordered by the first cell that both cover, and in a cell the one furthest to the back comes first. A box covers at
// most two cells along an axis, so there are at most eight such cells.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "collision/broadphase/dxPairRows.h"
#include "collision/spaces/dxHashCells.h"
#include "core/dxRadixSort.h"

class dxHashRows final : public dxPairRows {
public:
    // In place of those of the base: a geom has cells, too. Requires the order of the list, and none out of range.
    void clear();
    void push(dxGeom *geom, Slot slot, const dxPairFilter &filter, const dxBounds &box, const dxHashCells &cells);
    void finish();

    // Each geom of the table with those that it finds, front first; then each with the big ones; then the big ones among themselves.
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

    std::vector<Pushed> m_table, m_big;   // as they came
    std::vector<dxSortItem> m_byLevel, m_spare;
    std::vector<std::uint32_t> m_listed;  // the elements of the table in the order of the list
    std::vector<dxHashCells> m_cells;     // by element
    dxBoxColumns m_bigBoxes;
    std::vector<std::uint32_t> m_ordered;  // scratch of a row
    std::vector<std::uint8_t> m_corners;   // by place in m_found
};
