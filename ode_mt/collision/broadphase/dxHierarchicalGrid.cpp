#include "collision/broadphase/dxHierarchicalGrid.h"

int dxHierarchicalGrid::levelOf(const dxBounds &box) {
    if (!box.isProper()) return kApart;
    const dReal edge = box.longestEdge();
    if (!std::isfinite(edge)) return kApart;
    int level = kLowestLevel;
    if (edge > 0) std::frexp(edge, &level);  // 2^(level - 1) <= edge < 2^level
    level = std::max(level, kLowestLevel);
    Range range;
    return level <= kHighestLevel && cellsOf(box, level, range) ? level : kApart;
}

bool dxHierarchicalGrid::cellsOf(const dxBounds &box, int level, Range &range) {
    constexpr double kLargest = 1 << 30;
    const double cellsPerUnit = std::ldexp(1.0, -level);
    for (int axis = 0; axis < 3; ++axis) {
        const double low = std::floor(box.low(axis) * cellsPerUnit);
        const double high = std::floor(box.high(axis) * cellsPerUnit);
        if (!(low > -kLargest && high < kLargest)) return false;
        range.low[axis] = static_cast<std::int32_t>(low);
        range.high[axis] = static_cast<std::int32_t>(high);
    }
    return true;
}

std::size_t dxHierarchicalGrid::hashOf(std::int32_t level, std::int32_t x, std::int32_t y, std::int32_t z) {
    std::uint64_t hash = static_cast<std::uint32_t>(x) * UINT64_C(0x9E3779B97F4A7C15);
    hash ^= static_cast<std::uint32_t>(y) * UINT64_C(0xC2B2AE3D27D4EB4F);
    hash ^= static_cast<std::uint32_t>(z) * UINT64_C(0x165667B19E3779F9);
    hash ^= static_cast<std::uint32_t>(level) * UINT64_C(0xD6E8FEB86659FD93);
    return static_cast<std::size_t>(hash ^ (hash >> 32));
}

const dxHierarchicalGrid::Cell *dxHierarchicalGrid::find(std::int32_t level, std::int32_t x, std::int32_t y,
                                           std::int32_t z) const {
    const std::size_t mask = m_cells.size() - 1;
    for (std::size_t i = hashOf(level, x, y, z) & mask;; i = (i + 1) & mask) {
        const Cell &cell = m_cells[i];
        if (cell.level == kApart) return nullptr;
        if (cell.x == x && cell.y == y && cell.z == z && cell.level == level) return &cell;
    }
}

dxHierarchicalGrid::Cell &dxHierarchicalGrid::findOrMake(std::int32_t level, std::int32_t x, std::int32_t y,
                                           std::int32_t z) {
    if (2 * (m_usedCells + 1) > m_cells.size()) rebuildTable();
    if (const Cell *const cell = find(level, x, y, z)) return const_cast<Cell &>(*cell);
    const std::size_t mask = m_cells.size() - 1;
    std::size_t i = hashOf(level, x, y, z) & mask;
    while (m_cells[i].level != kApart) i = (i + 1) & mask;
    ++m_usedCells;
    return m_cells[i] = Cell{level, x, y, z, kNoIndex};
}

// Drops the empty cells, which moving boxes leave behind.
void dxHierarchicalGrid::rebuildTable() {
    constexpr std::size_t kSmallest = 64;
    std::vector<Cell> old;
    old.swap(m_cells);
    std::size_t occupied = 0;
    for (const Cell &cell : old) occupied += cell.level != kApart && cell.first != kNoIndex;
    std::size_t size = kSmallest;
    while (size < 4 * (occupied + 1)) size *= 2;
    m_cells.assign(size, Cell{kApart, 0, 0, 0, kNoIndex});
    m_usedCells = 0;
    for (const Cell &cell : old)
        if (cell.level != kApart && cell.first != kNoIndex)
            findOrMake(cell.level, cell.x, cell.y, cell.z).first = cell.first;
}

void dxHierarchicalGrid::enterCells(Slot slot, const Place &place) {
    forCells(place.cells, [&](std::int32_t x, std::int32_t y, std::int32_t z) {
        std::uint32_t entry = m_freeEntry;
        if (entry == kNoIndex) {
            entry = static_cast<std::uint32_t>(m_entries.size());
            m_entries.emplace_back();
        } else {
            m_freeEntry = m_entries[entry].next;
        }
        Cell &cell = findOrMake(place.level, x, y, z);
        m_entries[entry] = Entry{slot, cell.first};
        cell.first = entry;
    });
}

void dxHierarchicalGrid::leaveCells(Slot slot, const Place &place) {
    forCells(place.cells, [&](std::int32_t x, std::int32_t y, std::int32_t z) {
        std::uint32_t *link = &findOrMake(place.level, x, y, z).first;
        while (m_entries[*link].slot != slot) link = &m_entries[*link].next;
        const std::uint32_t entry = *link;
        *link = m_entries[entry].next;
        m_entries[entry].next = m_freeEntry;
        m_freeEntry = entry;
    });
}

void dxHierarchicalGrid::insert(Slot slot, const dxBounds &box) {
    if (slot >= m_places.size()) m_places.resize(slot + 1);
    if (m_cells.empty()) rebuildTable();
    Place &place = m_places[slot];
    place.level = levelOf(box);
    std::vector<Slot> &level = members(place.level);
    if (level.empty()) m_levelsInUse.push_back(place.level);
    place.indexInLevel = static_cast<std::uint32_t>(level.size());
    level.push_back(slot);
    if (place.level == kApart) return;
    cellsOf(box, place.level, place.cells);
    enterCells(slot, place);
}

void dxHierarchicalGrid::remove(Slot slot) {
    const Place &place = m_places[slot];
    if (place.level != kApart) leaveCells(slot, place);
    std::vector<Slot> &level = members(place.level);
    level[place.indexInLevel] = level.back();
    m_places[level.back()].indexInLevel = place.indexInLevel;
    level.pop_back();
    if (level.empty()) m_levelsInUse.erase(std::find(m_levelsInUse.begin(), m_levelsInUse.end(), place.level));
}
