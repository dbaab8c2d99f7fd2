// The members of a sweep-and-prune space in the two lists that upstream keeps: those that have changed, in
// the order in which they did, and the clean ones. What leaves a list has its place taken by the last one of
// it.
//
// Both orders show: in dSpaceGetGeom, in the callbacks of dSpaceCollide2, in what becomes of geoms with equal
// bounds. Not thread safe.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "collision/pairs/dxMembers.h"

class dxSweepLists {
public:
    using Slot = dxMembers::Slot;

    struct Entry {
        dxGeom *geom;
        Slot slot;
    };

    const std::vector<Entry> &dirty() const { return m_dirty; }
    const std::vector<Entry> &clean() const { return m_clean; }

    bool isDirty(Slot slot) const { return m_places[slot].isDirty; }
    // In the list in which the member is.
    std::size_t placeOf(Slot slot) const { return m_places[slot].index; }

    // Memory for members in the slots below: none of the other functions asks for any then.
    void makeRoom(Slot slots);
    // Behind the dirty ones.
    void add(Slot slot, dxGeom *geom);
    void remove(Slot slot);
    // A clean member goes behind the dirty ones.
    void makeDirty(Slot slot);
    // The dirty ones go behind the clean ones.
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
