#include "collision/spaces/dxHashWalk.h"

#include <algorithm>

#include "collision/spaces/dxPairDelivery.h"
#include "core/dxNoIndex.h"

struct dxHashWalk::Meeting {
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

void dxHashWalk::add(dxGeom *geom, const dxHashCells &cells) {
    if (cells.kind() == dxHashCells::Kind::big) {
        m_big.push_back(geom);
        return;
    }
    m_highestLevel = m_inTable.empty() ? cells.level() : std::max(m_highestLevel, cells.level());
    m_inTable.push_back({geom, cells});
}

void dxHashWalk::deliver(void *data, dNearCallback *callback, const dxOrderedPair *after) {
    Meeting meeting{data, callback, after};
    for (std::uint32_t searcher = 0; searcher < m_inTable.size(); ++searcher) search(searcher, meeting);
    for (const Boxed &boxed : m_inTable)
        for (dxGeom *const big : m_big) meeting.meet(boxed.geom, big);
    for (std::size_t i = 0; i < m_big.size(); ++i)
        for (std::size_t j = i + 1; j < m_big.size(); ++j) meeting.meet(m_big[i], m_big[j]);
}

// A table twice as large as there can be cells: few buckets hold more than one.
void dxHashWalk::storeAll() {
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

void dxHashWalk::store(std::uint32_t boxed, const Cell &cell) {
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

std::uint32_t dxHashWalk::find(const Cell &cell, int level) const {
    std::uint32_t number = m_buckets[bucketOf(cell, level)];
    while (number != kNoIndex && !(m_cells[number].level == level && m_cells[number].cell == cell))
        number = m_cells[number].before;
    return number;
}

std::size_t dxHashWalk::bucketOf(const Cell &cell, int level) const {
    const auto word = [](int value) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(value)); };
    std::uint64_t mixed = (word(cell.x) << 32 | word(cell.y)) * UINT64_C(0x9e3779b97f4a7c15);
    mixed = ((mixed ^ mixed >> 32) + (word(cell.z) << 32 | word(level))) * UINT64_C(0xc2b2ae3d27d4eb4f);
    return static_cast<std::size_t>(mixed >> 32) & (m_buckets.size() - 1);
}

// On its own level and those above. Of those in one cell the one that was stored last is met first. Of two on
// one level the first in the list has found the other, so the rest of a cell of its own level, itself first,
// is not met.
void dxHashWalk::search(std::uint32_t searcher, Meeting &meeting) {
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
