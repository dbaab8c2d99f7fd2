// Sorts by whole-numbered keys in a time that grows with the number of items alone.
//
// Digits of eight bits from the lowest up; those in which all keys agree are left out, so that keys of a
// narrow range cost few passes. Items with equal keys are left in the order of their indices, in which they must
// have come.
#pragma once

#include <cstdint>
#include <vector>

struct dxSortItem {
    std::uint64_t key;
    std::uint32_t index;        // the owner's
    std::uint32_t partner = 0;  // what else belongs to it; nothing is sorted by it
};

// `spare` is memory for the passes, kept by the owner from call to call.
void dxRadixSort(std::vector<dxSortItem> &items, std::vector<dxSortItem> &spare);
