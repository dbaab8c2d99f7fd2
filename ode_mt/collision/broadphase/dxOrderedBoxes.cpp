#include "collision/broadphase/dxOrderedBoxes.h"

#include "core/dxNoIndex.h"

namespace {

// Up to this number boxes are compared one by one as fast as with SIMD.
constexpr std::size_t kMaxComparedOneByOne = 16;

// Putting this many boxes into columns costs as much as one query saves.
constexpr std::size_t kBoxesPerQuery = 8;

}  // namespace

const std::vector<dxSortItem> &dxOrderedBoxes::update(const dxMembers &members) {
    if (!isCurrent(members)) {
        m_items = &m_order.update(members);
        m_orderings.store(members.orderings(), std::memory_order_release);
    }
    return *m_items;
}

bool dxOrderedBoxes::find(const dxMembers &members, const dxBounds &box, bool isFewElsewhere, Found &found) {
    if (members.end() > kMaxMembers) return false;
    const bool areFew = members.end() <= kMaxComparedOneByOne;
    bool useColumns = !areFew && hasColumns(members);
    if (!useColumns) {
        useColumns = !areFew && isColumnsDue(members);
        if (isFewElsewhere && !useColumns) return false;
        if (!makeReady(members, useColumns)) return false;
    }
    useColumns ? compareColumns(box, found) : compareOneByOne(members, box, found);
    return true;
}

void dxOrderedBoxes::compareColumns(const dxBounds &box, Found &found) const {
    found.count = m_overlappingRows(m_boxes, box, 0, m_boxes.size(), found.slots);
    for (std::size_t i = 0; i < found.count; ++i) found.slots[i] = (*m_items)[found.slots[i]].index;
}

// Compares axis after axis: comparisons of few boxes mostly have the same result, which is predicted.
void dxOrderedBoxes::compareOneByOne(const dxMembers &members, const dxBounds &box, Found &found) const {
    std::size_t count = 0;
    for (const dxSortItem &item : *m_items)
        if (dxOverlapInTurn(members[item.index].bounds.v, box.v)) found.slots[count++] = item.index;
    found.count = count;
}

// Counts this query.
bool dxOrderedBoxes::isColumnsDue(const dxMembers &members) {
    if (haveFewMoved(members)) return true;
    const std::size_t queries = m_queries.load(std::memory_order_relaxed) + 1;
    m_queries.store(queries, std::memory_order_relaxed);
    return queries > 1 + members.end() / kBoxesPerQuery;
}

// Returns whether few members have moved since the columns were filled, and none of them to another place in the order.
bool dxOrderedBoxes::haveFewMoved(const dxMembers &members) const {
    return m_columnsOrderings.load(std::memory_order_relaxed) == members.orderings() &&
           members.placings() - m_columnsPlacings.load(std::memory_order_relaxed) <= dxMembers::kPlacingsKnown;
}

bool dxOrderedBoxes::makeReady(const dxMembers &members, bool withColumns) {
    if (isCurrent(members) && !withColumns) return true;
    const std::unique_lock<std::mutex> alone(m_updating, std::try_to_lock);
    if (!alone) return false;
    update(members);
    if (withColumns && !hasColumns(members)) fillColumns(members);
    return true;
}

// An absent member has no row.
void dxOrderedBoxes::fillColumns(const dxMembers &members) {
    if (haveFewMoved(members)) {
        for (std::uint64_t placing = m_columnsPlacings.load(std::memory_order_relaxed); placing != members.placings(); ++placing) {
            const Slot slot = members.placed(placing);
            if (m_rowOf[slot] != kNoIndex) m_boxes.set(m_rowOf[slot], members[slot].bounds);
        }
    } else {
        m_columnsOrderings.store(kNever, std::memory_order_relaxed);  // if memory runs out half way
        m_boxes.clear();
        m_rowOf.assign(members.end(), kNoIndex);
        for (const dxSortItem &item : *m_items) {
            m_rowOf[item.index] = static_cast<std::uint32_t>(m_boxes.size());
            m_boxes.push(members[item.index].bounds);
        }
        m_columnsOrderings.store(members.orderings(), std::memory_order_release);
    }
    m_queries.store(0, std::memory_order_relaxed);
    m_columnsPlacings.store(members.placings(), std::memory_order_release);
}
