// Pairs of geoms in a space: by slots, in upstream's order, and what decides whether and where upstream's space calls a pair back.
#pragma once

#include <array>
#include <cstdint>

#include <ode/common.h>

// Two members of a space, known by their slots (dxMembers::Slot).
struct dxSlotPair {
    std::uint32_t a, b;
};

// Two members of a space whose boxes overlap, in the order of the callback's arguments.
struct dxOrderedPair {
    dxGeom *first, *second;
    std::uint32_t slots[2];
};

// What upstream's collideAABBs reads of a geom, besides its box. It is a copy, so that testing a pair causes no cache miss on the geoms.
struct dxPairFilter {
    const dxBody *body = nullptr;
    unsigned long category = ~0ul, collide = ~0ul;

    // Returns whether the filter may exclude a geom whose own filter excludes none.
    bool mayExclude() const { return body != nullptr || (category & collide) != ~0ul; }
};

// Returns whether both filters let the pair pass. Branch-free: branches would be mispredicted where about half of the pairs are excluded.
inline bool dxFiltersAgree(const dxPairFilter &a, const dxPairFilter &b) {
    const bool haveOneBody = (a.body == b.body) & (a.body != nullptr);
    return !haveOneBody & (((a.category & b.collide) | (b.category & a.collide)) != 0);
}

// A member's place in upstream's list of geoms: of two members, the one with the higher rank is further to the front.
using dxRank = std::uint64_t;

// The place of a pair of geoms in the order in which upstream's space would call back.
//
// Upstream walks its list of geoms. So the order of pairs, and of the two geoms in a pair, follows from the geoms' places in the list, which ranks
// tell. The first word is the primary key, the others are the secondary key; keys compare by their words in turn. docs/collision.md derives both
// orders.
struct dxPairKey {
    std::array<std::uint64_t, 4> words;

    friend bool operator<(const dxPairKey &a, const dxPairKey &b) { return a.words < b.words; }
};

// Returns a key that sorts from the front of the list to the back.
inline std::uint64_t dxFrontFirst(dxRank rank) { return ~rank; }
// Returns a key that sorts from the back of the list to the front.
inline std::uint64_t dxBackFirst(dxRank rank) { return rank; }
