#include "collision/spaces/dxQuadRows.h"

namespace {

// To put a box into columns takes as long as to compare it with so many.
constexpr std::size_t kMaxPackedPerGeom = 16;

}  // namespace

void dxQuadRows::clear(std::size_t mostGeoms) {
    dxPairRows::clear();
    m_blocks.clear();
    if (m_packed.size() < mostGeoms) m_packed.resize(mostGeoms);
}

// Blocks are numbered from the root on, each before those within it: those that an element ends are the innermost that are open.
void dxQuadRows::finish() {
    makeRoom();
    m_ends.resize(geoms());
    m_open.clear();
    m_candidates = 0;
    const auto close = [this](std::uint32_t end) {
        const std::uint32_t first = m_open.back();
        m_open.pop_back();
        for (std::uint32_t row = first; row < end && m_blocks[row] == m_blocks[first]; ++row) {
            m_ends[row] = end;
            m_candidates += end - row - 1;
        }
    };
    for (std::uint32_t row = 0; row < geoms(); ++row) {
        if (row != 0 && m_blocks[row] == m_blocks[row - 1]) continue;
        while (!m_open.empty() && m_tree.endOf(m_blocks[m_open.back()]) <= m_blocks[row]) close(row);
        m_open.push_back(row);
    }
    while (!m_open.empty()) close(static_cast<std::uint32_t>(geoms()));
    m_areFew = m_candidates <= kMaxPackedPerGeom * geoms();
    if (m_areFew) return;
    for (std::size_t row = 0; row < geoms(); ++row) m_boxes.push(m_packed.box(row));
}

std::size_t dxQuadRows::find(std::size_t row) {
    return keepAgreeing(row, m_areFew ? findPacked(row) : findBetween(row + 1, m_ends[row], m_boxes, m_packed.box(row)));
}

std::size_t dxQuadRows::findPacked(std::size_t row) {
    const std::size_t count = m_overlappingSlots(m_packed, row, row + 1, m_ends[row], m_found.data());
    countWork(m_ends[row] - row - 1, count);
    return count;
}
