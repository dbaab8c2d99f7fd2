#include "core/dxRadixSort.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace {

constexpr int kDigitBits = 8;
constexpr std::size_t kDigits = std::size_t{1} << kDigitBits;
constexpr std::size_t kFew = 64;

std::uint64_t keyOf(const dxSortItem &item) { return item.key; }
std::uint64_t keyOf(std::uint64_t number) { return number >> 32; }

bool isBefore(const dxSortItem &a, const dxSortItem &b) { return a.key != b.key ? a.key < b.key : a.index < b.index; }
bool isBefore(std::uint64_t a, std::uint64_t b) { return a < b; }

template <class Item>
std::uint64_t bitsThatVary(const std::vector<Item> &items) {
    std::uint64_t varying = 0;
    for (const Item &item : items) varying |= keyOf(item) ^ keyOf(items.front());
    return varying;
}

// Consecutive bits of a key.
struct Bits {
    int shift = 0, count = 0;

    std::uint64_t of(std::uint64_t key) const { return key >> shift & ((std::uint64_t{1} << count) - 1); }
};

// Returns the lowest consecutive bits that vary, `most` at most, and removes them from `varying`.
Bits takeBits(std::uint64_t &varying, int most) {
    Bits bits;
    if (varying == 0) return bits;
    while ((varying >> bits.shift & 1) == 0) ++bits.shift;
    while (bits.count < most && bits.shift + bits.count < 64 && (varying >> (bits.shift + bits.count) & 1) != 0) ++bits.count;
    varying &= ~(((std::uint64_t{1} << bits.count) - 1) << bits.shift);
    return bits;
}

template <class Item, class DigitOf>
void sortByDigit(const std::vector<Item> &from, std::vector<Item> &to, DigitOf digitOf) {
    std::array<std::uint32_t, kDigits> next{};
    for (const Item &item : from) ++next[digitOf(keyOf(item))];
    std::uint32_t begin = 0;
    for (std::uint32_t &count : next) {
        const std::uint32_t size = count;
        count = begin;
        begin += size;
    }
    for (const Item &item : from) to[next[digitOf(keyOf(item))]++] = item;
}

template <class Item>
void sort(std::vector<Item> &items, std::vector<Item> &spare) {
    // Not std::stable_sort, which takes memory.
    if (items.size() < kFew) return std::sort(items.begin(), items.end(), [](const Item &a, const Item &b) { return isBefore(a, b); });
    spare.resize(items.size());
    std::uint64_t varying = bitsThatVary(items);
    while (varying != 0) {
        const Bits low = takeBits(varying, kDigitBits), high = takeBits(varying, kDigitBits - low.count);
        if (high.count == 0)
            sortByDigit(items, spare, [low](std::uint64_t key) { return low.of(key); });
        else
            sortByDigit(items, spare, [low, high](std::uint64_t key) { return low.of(key) | high.of(key) << low.count; });
        items.swap(spare);
    }
}

}  // namespace

void dxRadixSort(std::vector<dxSortItem> &items, std::vector<dxSortItem> &spare) { sort(items, spare); }

void dxRadixSort(std::vector<std::uint64_t> &numbers, std::vector<std::uint64_t> &spare) { sort(numbers, spare); }
