// Radix sort by integer keys, linear in the number of items.
//
// Digits have eight bits, the lowest first, from one or two places of the key. Bits in which all keys agree are left out, so keys
// of a narrow range need few passes. Items with equal keys keep the order of their indices. Requires items in the order of their indices.
//
// Threading: one thread for one pair of arrays.
#pragma once

#include <cstdint>
#include <vector>

struct dxSortItem {
    std::uint64_t key;
    std::uint32_t index;        // the owner's
    std::uint32_t partner = 0;  // further data of the item; not a sort key
};

// `spare` is scratch for the passes, which the owner keeps from call to call.
void dxRadixSort(std::vector<dxSortItem> &items, std::vector<dxSortItem> &spare);

// The same for numbers whose upper 32 bits are the key, and whose lower ones are the index.
void dxRadixSort(std::vector<std::uint64_t> &numbers, std::vector<std::uint64_t> &spare);
