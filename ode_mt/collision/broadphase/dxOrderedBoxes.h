// The present members of a space in the order of their ranks, and what of them a box overlaps, in that order.
//
// After some queries the boxes are put into columns, which are compared by vectors: up to some hundred boxes no tree answers faster. A few members
// that move and keep their places in the order are brought up to date there.
//
// Threading: update() and changes of the members one thread at a time. Several threads may query while no member changes; one of them brings
// up to date what is not, and the others ask elsewhere meanwhile. No thread waits, and none reads what is rewritten: nothing is while the
// members stay as they are.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

#include "collision/broadphase/overlap/dxBoxColumns.h"
#include "collision/pairs/dxMembers.h"
#include "collision/pairs/dxRankOrder.h"

class dxOrderedBoxes {
public:
    using Slot = dxMembers::Slot;

    // Of more members nothing is found.
    static constexpr std::size_t kMaxMembers = 512;
    // Room for what is found. It is not initialised.
    struct Found {
        std::size_t count;
        Slot slots[kMaxMembers];
    };

    // As dxRankOrder::update().
    const std::vector<dxSortItem> &update(const dxMembers &members);

    // Finds the members whose boxes overlap a box, the one furthest to the front first. Returns false if another thread is bringing the order up to
    // date; or, if there is a faster way without columns, until there have been queries enough to pay for these. Throws std::bad_alloc; then the call
    // may be repeated.
    bool find(const dxMembers &members, const dxBounds &box, bool isFewElsewhere, Found &found);
    // Returns whether find() compares by vectors now.
    bool hasColumns(const dxMembers &members) const {
        return m_columnsPlacings.load(std::memory_order_acquire) == members.placings() &&
               m_columnsOrderings.load(std::memory_order_acquire) == members.orderings();
    }

private:
    static constexpr std::uint64_t kNever = ~std::uint64_t{0};

    bool isCurrent(const dxMembers &members) const { return m_orderings.load(std::memory_order_acquire) == members.orderings(); }
    bool isColumnsDue(const dxMembers &members);
    bool haveFewMoved(const dxMembers &members) const;
    void fillColumns(const dxMembers &members);
    bool makeReady(const dxMembers &members, bool withColumns);
    void compareOneByOne(const dxMembers &members, const dxBounds &box, Found &found) const;
    void compareByVectors(const dxBounds &box, Found &found) const;

    dxRankOrder m_order;
    const std::vector<dxSortItem> *m_items = nullptr;
    dxBoxColumns m_boxes;  // of the items
    dxOverlappingRowsKernel m_overlappingRows = dxKernelOfOverlappingRows();
    std::vector<std::uint32_t> m_rowOf;  // by slot
    std::atomic<std::uint64_t> m_orderings{kNever};  // dxMembers::orderings() at the last update
    std::atomic<std::uint64_t> m_columnsOrderings{kNever}, m_columnsPlacings{0};  // the same of the columns, and dxMembers::placings()
    std::atomic<std::size_t> m_queries{0};           // without columns since these were filled
    std::mutex m_updating;                           // only ever tried
};
