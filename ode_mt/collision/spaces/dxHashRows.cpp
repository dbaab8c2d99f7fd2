#include "collision/spaces/dxHashRows.h"

#include <algorithm>

namespace {

// Of a geom that upstream does not find, as it loses the pair.
constexpr std::uint8_t kLost = 8;

constexpr int kCorners = 8;

}  // namespace

void dxHashRows::clear() {
    dxPairRows::clear();
    m_table.clear();
    m_big.clear();
    m_bigBoxes.clear();
    m_byLevel.clear();
}

void dxHashRows::push(dxGeom *geom, Slot slot, const dxPairFilter &filter, const dxBounds &box, const dxHashCells &cells) {
    const bool isBig = cells.kind() == dxHashCells::Kind::big;
    if (!isBig) {
        const auto biased = static_cast<std::uint32_t>(cells.level()) ^ UINT32_C(0x80000000);
        m_byLevel.push_back({biased, static_cast<std::uint32_t>(m_table.size())});
    }
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

// A counting sort by the cell, from the back, so that equal ones are reversed. Returns the place behind the last.
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
