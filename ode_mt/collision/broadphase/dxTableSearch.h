// Pairs of a small space: the boxes that have changed against all others, by vectors.
//
// A member's row in the table is its slot, so that a change writes one row and nothing has to be sorted beforehand.
// A search costs changed x all / vector length comparisons, so it is for spaces of some hundred geoms.
#pragma once

#include <vector>

#include "collision/broadphase/dxPairSearch.h"
#include "collision/broadphase/overlap/dxBoxTable.h"

class dxTableSearch final : public dxPairSearch {
public:
    void search(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches) override;

    // Takes the members that have not changed as they are.
    void adopt(const dxMembers &members);

private:
    using Slot = dxMembers::Slot;

    void searchAll(const dxMembers &members, std::vector<Match> &matches);
    void searchChanged(const dxMembers &members, std::vector<Match> &matches);

    dxBoxTable m_boxes;              // by slot; of members that have gone, the last one
    std::vector<dxSlotPair> m_found;
    std::vector<std::uint32_t> m_rows;
};
