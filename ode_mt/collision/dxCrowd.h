// A space of which so many pairs overlap that keeping them costs more time and memory than testing all of its geoms
// against each other at each call, as upstream does.
//
// A crowd is walked for some calls before its pairs are counted again: counting ends when there are too many, and costs
// about a tenth of a walk.
#pragma once

#include <algorithm>
#include <cstddef>

class dxCrowd {
public:
    // The most pairs that are kept for so many geoms. Testing two boxes takes about a twentieth of the time that finding,
    // sorting and keeping a pair does; and a pair takes some hundred bytes while it is found.
    static constexpr std::size_t mostPairs(std::size_t geoms) {
        return std::clamp(geoms * geoms / 32, std::size_t{1} << 19, std::size_t{1} << 24);
    }

    bool isOne() const { return m_calls != 0; }
    void become() { m_calls = kCalls; }
    // At the beginning of a call of a crowd. True: it is time to count again.
    bool isOver() { return --m_calls == 0; }

private:
    static constexpr int kCalls = 32;

    int m_calls = 0;  // that it is to be walked yet
};
