// Lists of the joints that have rows on a body: each link is a joint as seen from one of its bodies. The lists are arrays of
// links, not of pointers, so that they need no initialisation but that of their heads.
#pragma once

namespace dxBodyLinks {

constexpr unsigned kSides = 2;
constexpr unsigned kNone = 0;  // ends a list

inline unsigned linkOf(unsigned joint, unsigned side) { return joint * kSides + side + 1; }
inline unsigned jointOf(unsigned link) { return (link - 1) / kSides; }
inline unsigned sideOf(unsigned link) { return (link - 1) % kSides; }

// The lists of all bodies.
struct Lists {
    unsigned *first = nullptr;  // by body
    unsigned *next = nullptr;   // by link - 1

    void add(unsigned body, unsigned link) const {
        next[link - 1] = first[body];
        first[body] = link;
    }
    unsigned after(unsigned link) const { return next[link - 1]; }
};

}  // namespace dxBodyLinks
