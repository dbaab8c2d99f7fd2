// A space of which so many pairs overlap that keeping them costs more time and memory than testing all of its geoms
// against each other at each call, as upstream does.
//
// A crowd is walked for some calls before its pairs are counted again: counting ends when there are too many, and costs
// about a tenth of a walk.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

class dxCrowd {
public:
    // The most pairs that are kept for so many geoms, never fewer than this.
    using Limit = std::size_t (*)(std::size_t geoms);
    static constexpr std::size_t leastLimit = std::size_t{1} << 19;
    static std::size_t allPairs(std::size_t) { return SIZE_MAX; }
    // Where a walk tests every two boxes. Testing two boxes takes about a twentieth of the time that finding,
    // sorting and keeping a pair does; and a pair takes some hundred bytes while it is found.
    static constexpr std::size_t mostPairs(std::size_t geoms) {
        return std::clamp(geoms * geoms / 32, leastLimit, std::size_t{1} << 24);
    }
    // Where a walk goes from cell to cell (dxHashWalk), which takes as long for a pair as finding and sorting it: the limit
    // is for memory, half a GB while pairs are found.
    static std::size_t mostPairsOfCells(std::size_t) { return std::size_t{1} << 22; }

    bool isOne() const { return m_calls != 0; }
    void become() { m_calls = kCalls; }
    // At the beginning of a call of a crowd. True: it is time to count again.
    bool isOver() { return --m_calls == 0; }

private:
    static constexpr int kCalls = 32;

    int m_calls = 0;  // that it is to be walked yet
};
