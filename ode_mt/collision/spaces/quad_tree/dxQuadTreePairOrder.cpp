#include "collision/spaces/quad_tree/dxQuadTreePairOrder.h"

namespace {

// Comparisons per geom, up to which columns do not pay: putting a box into columns takes as long as these.
constexpr std::size_t kMaxPackedPerGeom = 16;

}  // namespace

void dxQuadRows::clear(std::size_t maxGeoms) {
    dxPairRows::clear();
    m_blocks.clear();
    if (m_packed.size() < maxGeoms) m_packed.resize(maxGeoms);
}

// Blocks are numbered from the root on, each before the blocks within it. So an element in a new block closes the innermost open blocks,
// up to one that contains the new block.
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

// The number of comparisons that finding all pairs anew would take depends on how geoms lie in the tree. The rows of the last such call tell it;
// they are gathered again if there are none or the number of geoms has changed much.
void dxQuadTreePairOrder::update(std::vector<dxOrderedPair> &pairs, dxPairWork &work) {
    if (m_rows.geoms() > 2 * work.geoms || work.geoms > 2 * m_rows.geoms()) gatherRows();
    work.comparisons = m_rows.candidates();
    dxRankPairOrder::update(pairs, work);
}

dxPairRows &dxQuadTreePairOrder::gatherRows() {
    const dxMembers &members = geoms().members();
    const std::vector<dxSortItem> &order = m_boxes.update(members);
    m_rows.clear(order.size());
    for (const dxSortItem &item : order) {
        const dxMembers::Member &member = members[item.index];
        m_rows.push(member.geom, item.index, member.filter, member.bounds, m_ranks.blockOf(member.rank));
    }
    m_rows.finish();
    return m_rows;
}
