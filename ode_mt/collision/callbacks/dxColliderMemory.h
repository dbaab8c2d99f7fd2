// What colliders of a space's pairs write to, besides geoms of the pair itself: the scratch memory in the data of height
// fields, and geoms in geom transforms, which are put in the transform's place for a while. Several members of the space may
// have them in common. And which members lead to a height field, which turns the geom that it meets into its own frame.
//
// A nested space represents everything in it.
#pragma once

#include <cstdint>
#include <vector>

#include "collision/pairs/dxMembers.h"

struct dxGeom;

class dxColliderMemory {
public:
    using Slot = dxMembers::Slot;
    struct Use {
        const void *memory;
        Slot slot;  // of the member that has it
    };

    void reset(Slot end);
    void look(const dxGeom *member, Slot slot);  // once for each member
    void sort();

    bool hasHeights(Slot slot) const { return (m_members[slot] & kHasHeights) != 0; }
    // Uses of the same memory are neighbours. After sort().
    const std::vector<Use> &uses() const { return m_uses; }

private:
    void add(const dxGeom *geom, Slot slot);

    static constexpr std::uint8_t kSeen = 1, kHasHeights = 2;
    std::vector<std::uint8_t> m_members;  // by slot
    std::vector<Use> m_uses;
};
