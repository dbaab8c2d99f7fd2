// The present members of a space in the order of their ranks, and queries of those that a box overlaps, in that order.
//
// After some queries the boxes are put into columns, which are compared with SIMD: up to some hundred boxes no tree answers faster. If few members
// have moved, and kept their places in the order, only their rows are rewritten.
//
// Threading: update() and changes of the members by one thread at a time. Several threads may query while no member changes: one of them updates the
// order and the columns; find() returns false to the others meanwhile. No thread waits. Up-to-date columns are not rewritten while no member
// changes, so no thread reads what another one writes.
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

    // In a larger space find() returns false.
    static constexpr std::size_t kMaxMembers = 512;
    // Room for what is found. It is not initialised.
    struct Found {
        std::size_t count;
        Slot slots[kMaxMembers];
    };

    // Does the same as dxRankOrder::update().
    const std::vector<dxSortItem> &update(const dxMembers &members);

    // Finds the members whose boxes overlap a box, the one furthest to the front first. Returns false while another thread updates the order; or,
    // if there is a faster way than comparing one by one (`isFewElsewhere`), until there have been enough queries to pay for columns. Throws
    // std::bad_alloc; then the call may be repeated.
    bool find(const dxMembers &members, const dxBounds &box, bool isFewElsewhere, Found &found);
    // Returns whether find() compares columns now.
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
    void compareColumns(const dxBounds &box, Found &found) const;

    dxRankOrder m_order;
    const std::vector<dxSortItem> *m_items = nullptr;
    dxBoxColumns m_boxes;  // of the items
    dxOverlappingRowsKernel m_overlappingRows = dxKernelOfOverlappingRows();
    std::vector<std::uint32_t> m_rowOf;  // by slot
    std::atomic<std::uint64_t> m_orderings{kNever};  // dxMembers::orderings() at the last update
    std::atomic<std::uint64_t> m_columnsOrderings{kNever}, m_columnsPlacings{0};  // the same of the columns, and dxMembers::placings()
    std::atomic<std::size_t> m_queries{0};           // without columns, since they were last filled
    std::mutex m_updating;                           // only try_lock is used
};
