#include "collision/spaces/dxSapLists.h"

#include "core/dxReserve.h"

void dxSapLists::reserveMemory(Slot slots) {
    dxReserveCapacity(m_dirty, slots);
    dxReserveCapacity(m_clean, slots);
    dxReserveCapacity(m_places, slots);
}

void dxSapLists::add(Slot slot, dxGeom *geom) { append({geom, slot}, true); }

void dxSapLists::append(const Entry &entry, bool isDirty) {
    std::vector<Entry> &list = isDirty ? m_dirty : m_clean;
    if (entry.slot >= m_places.size()) m_places.resize(entry.slot + 1);
    m_places[entry.slot] = {static_cast<std::uint32_t>(list.size()), isDirty};
    list.push_back(entry);
}

void dxSapLists::remove(Slot slot) {
    std::vector<Entry> &list = m_places[slot].isDirty ? m_dirty : m_clean;
    const std::uint32_t index = m_places[slot].index;
    list[index] = list.back();
    m_places[list[index].slot].index = index;
    list.pop_back();
}

void dxSapLists::makeDirty(Slot slot) {
    const Entry entry = m_clean[m_places[slot].index];
    remove(slot);
    append(entry, true);
}

void dxSapLists::cleanAll() {
    for (const Entry &entry : m_dirty) append(entry, false);
    m_dirty.clear();
}
