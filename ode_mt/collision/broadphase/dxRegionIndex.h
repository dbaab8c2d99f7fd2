// Which members of a space overlap a given box: for rays, sensors, and whatever else is tested against a
// whole space.
//
// Members that rest are in a tree (overlap/dxBoxTree.h). One that changes becomes loose, and is compared with
// every box asked for. Comparing loose members costs time with each question, building the tree costs it
// once: the tree is built anew when the comparisons made since have cost as much. So a space that is never
// asked builds none, and in one that is asked often, whether or not things move in it, a question costs a
// logarithm.
//
// Several threads may ask while no member changes. One of them builds the tree, the others compare all
// members meanwhile: nobody waits, so nobody can wait for a thread that a fork has left behind. A question is
// answered from memory of the asker's; no lock is held when find() returns.
#pragma once

#include <atomic>
#include <memory_resource>
#include <shared_mutex>
#include <vector>

#include "collision/broadphase/overlap/dxBoxTree.h"
#include "collision/pairs/dxMembers.h"
#include "core/dxNoIndex.h"
#include "core/dxRadixSort.h"

class dxRegionIndex {
public:
    using Slot = dxMembers::Slot;

    // The member is new or has changed. Does nothing before the first question. Without memory for that the
    // tree is given up, until it is built anew.
    void loosen(Slot slot) noexcept;
    // The member has gone. Likewise nothing before the first question.
    void drop(Slot slot);

    // Fills `found` with the members whose boxes overlap `box`, the one furthest to the front of the list
    // first.
    void find(const dxMembers &members, const dxBounds &box, std::pmr::vector<Slot> &found);

private:
    struct Home {
        std::uint32_t row = kNoIndex;    // in the tree
        std::uint32_t loose = kNoIndex;  // place in m_loose
    };

    Home &homeOf(Slot slot);
    void joinLoose(Slot slot);
    void leaveLoose(Home &home);
    bool query(const dxMembers &members, const dxBounds &box, std::pmr::vector<Slot> &found);
    void buildIfDue(const dxMembers &members);
    void build(const dxMembers &members);
    void sortAlongCurve(const dxMembers &members);

    std::shared_mutex m_mutex;  // only ever tried: shared to query, exclusive to build
    bool m_isInUse = false;     // since the first question all members are in the tree or loose
    std::vector<Home> m_homes;  // by slot
    std::vector<Slot> m_loose;
    std::vector<Slot> m_slotOfRow;
    dxBoxTree m_tree;
    std::atomic<std::size_t> m_debt{0};  // comparisons outside the tree since it was built
    std::vector<dxSortItem> m_items, m_spare;
};
