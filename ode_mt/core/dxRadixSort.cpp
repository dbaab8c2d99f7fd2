#include "core/dxRadixSort.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace {

constexpr int kDigitBits = 8;
constexpr std::size_t kDigits = std::size_t{1} << kDigitBits;
constexpr std::size_t kFew = 64;

std::uint64_t bitsThatVary(const std::vector<dxSortItem> &items) {
    std::uint64_t varying = 0;
    for (const dxSortItem &item : items) varying |= item.key ^ items.front().key;
    return varying;
}

void sortByDigit(const std::vector<dxSortItem> &from, std::vector<dxSortItem> &to, int shift) {
    const auto digitOf = [shift](const dxSortItem &item) { return item.key >> shift & (kDigits - 1); };
    std::array<std::uint32_t, kDigits> next{};
    for (const dxSortItem &item : from) ++next[digitOf(item)];
    std::uint32_t begin = 0;
    for (std::uint32_t &count : next) {
        const std::uint32_t size = count;
        count = begin;
        begin += size;
    }
    for (const dxSortItem &item : from) to[next[digitOf(item)]++] = item;
}

}  // namespace

void dxRadixSort(std::vector<dxSortItem> &items, std::vector<dxSortItem> &spare) {
    if (items.size() < kFew) {
        // Not std::stable_sort, which takes memory.
        std::sort(items.begin(), items.end(), [&](const dxSortItem &a, const dxSortItem &b) {
            return a.key != b.key ? a.key < b.key : a.index < b.index;
        });
        return;
    }
    spare.resize(items.size());
    const std::uint64_t varying = bitsThatVary(items);
    for (int shift = 0; shift < 64; shift += kDigitBits) {
        if ((varying >> shift & (kDigits - 1)) == 0) continue;
        sortByDigit(items, spare, shift);
        items.swap(spare);
    }
}
