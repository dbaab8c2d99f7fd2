#include "collision/broadphase/dxOrderedBoxes.h"

namespace {

// Up to so many are compared one by one as fast as by vectors.
constexpr std::size_t kFewMembers = 16;

// Queries of members that stay where they are, after which it pays to put their boxes into columns.
constexpr unsigned kQueriesPerFill = 2;

}  // namespace

const std::vector<dxSortItem> &dxOrderedBoxes::update(const dxMembers &members) {
    if (!isCurrent(members)) {
        m_items = &m_order.update(members);
        m_orderings.store(members.orderings(), std::memory_order_release);
    }
    return *m_items;
}

bool dxOrderedBoxes::find(const dxMembers &members, const dxBounds &box, bool isFewElsewhere, Found &found) {
    if (members.end() > kMostMembers) return false;
    const bool areFew = members.end() <= kFewMembers;
    if (areFew || !hasColumns(members)) {
        const bool withColumns = !areFew && isColumnsDue(members);
        if (isFewElsewhere && !withColumns) return false;
        if (!makeReady(members, withColumns)) return false;
    }
    if (areFew || !hasColumns(members)) {
        compareOneByOne(members, box, found);
    } else {
        found.count = m_overlappingRows(m_boxes, box, 0, m_boxes.size(), found.slots);
        for (std::size_t i = 0; i < found.count; ++i) found.slots[i] = (*m_items)[found.slots[i]].index;
    }
    return true;
}

// In turn, as the comparisons of few boxes mostly come out alike.
void dxOrderedBoxes::compareOneByOne(const dxMembers &members, const dxBounds &box, Found &found) const {
    std::size_t count = 0;
    for (const dxSortItem &item : *m_items)
        if (dxOverlapInTurn(members[item.index].bounds.v, box.v)) found.slots[count++] = item.index;
    found.count = count;
}

// Counts this query.
bool dxOrderedBoxes::isColumnsDue(const dxMembers &members) {
    const std::uint64_t now = members.boxes();
    const bool isFirst = m_queriedAt.exchange(now, std::memory_order_relaxed) != now;
    const unsigned queries = isFirst ? 1 : m_queries.load(std::memory_order_relaxed) + 1;
    m_queries.store(queries, std::memory_order_relaxed);
    return queries > kQueriesPerFill;
}

bool dxOrderedBoxes::makeReady(const dxMembers &members, bool withColumns) {
    if (isCurrent(members) && !withColumns) return true;
    const std::unique_lock<std::mutex> alone(m_updating, std::try_to_lock);
    if (!alone) return false;
    update(members);
    if (!withColumns || hasColumns(members)) return true;
    m_boxes.clear();
    for (const dxSortItem &item : *m_items) m_boxes.push(members[item.index].bounds);
    m_columnsOf.store(members.boxes(), std::memory_order_release);
    return true;
}
