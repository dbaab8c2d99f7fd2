// The members of a sweep-and-prune space in the two lists that upstream keeps: those that have changed, in the order in
// which they did, and the clean ones. The place of a removed entry is taken by the last one of its list.
//
// Both orders are visible: in dSpaceGetGeom, in the callbacks of dSpaceCollide2, in the order of geoms with equal
// bounds. Threading: not thread-safe.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "collision/pairs/dxMembers.h"

class dxSapLists {
public:
    using Slot = dxMembers::Slot;

    struct Entry {
        dxGeom *geom;
        Slot slot;
    };

    const std::vector<Entry> &dirty() const { return m_dirty; }
    const std::vector<Entry> &clean() const { return m_clean; }

    bool isDirty(Slot slot) const { return m_places[slot].isDirty; }
    // Returns the index of a member in its list.
    std::size_t placeOf(Slot slot) const { return m_places[slot].index; }

    // Reserves memory for members in the slots below `slots`; the other functions then allocate nothing.
    void reserveMemory(Slot slots);
    // Appends a member to the dirty ones.
    void add(Slot slot, dxGeom *geom);
    void remove(Slot slot);
    // Moves a clean member behind the dirty ones.
    void makeDirty(Slot slot);
    // Moves the dirty ones behind the clean ones.
    void cleanAll();

private:
    struct Place {
        std::uint32_t index;
        bool isDirty;
    };

    void append(const Entry &entry, bool isDirty);

    std::vector<Entry> m_dirty, m_clean;
    std::vector<Place> m_places;  // by slot
};
