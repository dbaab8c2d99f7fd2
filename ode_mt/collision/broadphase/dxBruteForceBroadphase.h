// Brute force for a small space: the changed boxes against all others, with SIMD.
//
// A member's row is its slot, so a change writes one row and no sort is needed beforehand. A call costs changed x all /
// vector length comparisons, so the class is for spaces of some hundred geoms.
#pragma once

#include <vector>

#include "collision/broadphase/dxBroadphase.h"
#include "collision/broadphase/overlap/dxBoxColumns.h"

class dxBruteForceBroadphase final : public dxBroadphase {
public:
    void findOverlaps(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches) override;

    // Takes over the members that have not changed.
    void adopt(const dxMembers &members);

private:
    using Slot = dxMembers::Slot;

    void searchAll(const dxMembers &members, std::vector<Match> &matches);
    void findPairsOfChanged(const dxMembers &members, std::vector<Match> &matches);

    dxBoxColumns m_boxes;              // by slot; removed members keep their last box
    std::vector<dxSlotPair> m_found;
    std::vector<std::uint32_t> m_rows;
};
