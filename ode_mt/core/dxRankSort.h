// The order in which upstream's sweep-and-prune space takes its geoms: by a number each, and among equal numbers by what
// happened at earlier calls.
//
// Upstream's radix sort begins with the order of its last call if there are as many numbers as then, else with
// that of their indices, and changes nothing if the numbers do not fall along it. Otherwise numbers rise, by
// their bits (-0 before 0), and of equal ones those with their sign bit clear keep that order while those with it
// set reverse it. So the order of indices is a state that every call of upstream's changes, and so must every one
// here. docs/collision-order.md.
// Not thread safe.
#pragma once

#include <cstdint>
#include <vector>

#include "core/dxRadixSort.h"

class dxRankSort {
public:
    // The indices of `keys` in order. NaN may be among them: it is placed by its bits.
    const std::vector<std::uint32_t> &sort(const std::vector<float> &keys);

private:
    bool isInOrder(const std::vector<float> &keys) const;
    void takeTurns(const std::vector<float> &keys);

    std::vector<std::uint32_t> m_order;
    std::vector<std::uint32_t> m_turns;  // indices so that a stable sort gives equal keys their order
    std::vector<dxSortItem> m_items, m_spare;
};
