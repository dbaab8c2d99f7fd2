// Queue of the dirty members of a space, in the order of insertion, each once.
//
// Upstream's quad tree may have a geom twice in its list; the second cleaning changes nothing.
#pragma once

#include <vector>

#include "collision/pairs/dxMembers.h"
#include "core/dxNoIndex.h"

class dxDirtyQueue {
public:
    using Slot = dxMembers::Slot;

    // Reserves memory for members in the slots below `slots`; the other functions then allocate nothing.
    void reserveMemory(Slot slots);
    // Does nothing if the member is in the queue.
    void push(dxGeom *geom, Slot slot);
    // Removes the member, if it is in the queue.
    void drop(Slot slot);
    void clear();

    bool isEmpty() const { return m_geoms.empty(); }
    bool has(Slot slot) const { return slot < m_places.size() && m_places[slot] != kNoIndex; }

    const std::vector<dxGeom *> &geoms();

private:
    void close();

    std::vector<dxGeom *> m_geoms;        // NULL: dropped
    std::vector<Slot> m_slots;            // of the geoms
    std::vector<std::uint32_t> m_places;  // by slot
    std::size_t m_dropped = 0;
};
