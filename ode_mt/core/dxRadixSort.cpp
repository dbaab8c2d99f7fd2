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

// Consecutive bits of a key.
struct Bits {
    int shift = 0, count = 0;

    std::uint64_t of(std::uint64_t key) const { return key >> shift & ((std::uint64_t{1} << count) - 1); }
};

// The lowest `most` bits at most of those that vary, which are taken from `varying`.
Bits takeBits(std::uint64_t &varying, int most) {
    Bits bits;
    if (varying == 0) return bits;
    while ((varying >> bits.shift & 1) == 0) ++bits.shift;
    while (bits.count < most && bits.shift + bits.count < 64 && (varying >> (bits.shift + bits.count) & 1) != 0) ++bits.count;
    varying &= ~(((std::uint64_t{1} << bits.count) - 1) << bits.shift);
    return bits;
}

void sortByDigit(const std::vector<dxSortItem> &from, std::vector<dxSortItem> &to, Bits low, Bits high) {
    const auto digitOf = [low, high](const dxSortItem &item) { return low.of(item.key) | high.of(item.key) << low.count; };
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
    std::uint64_t varying = bitsThatVary(items);
    while (varying != 0) {
        const Bits low = takeBits(varying, kDigitBits), high = takeBits(varying, kDigitBits - low.count);
        sortByDigit(items, spare, low, high);
        items.swap(spare);
    }
}
