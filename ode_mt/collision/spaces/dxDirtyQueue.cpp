#include "collision/spaces/dxDirtyQueue.h"

#include "core/dxReserve.h"

// At most half of the queue may consist of dropped entries (push).
void dxDirtyQueue::reserveMemory(Slot slots) {
    dxReserveCapacity(m_places, slots);
    dxReserveCapacity(m_geoms, 2 * std::size_t{slots} + 2);
    dxReserveCapacity(m_slots, 2 * std::size_t{slots} + 2);
}

void dxDirtyQueue::push(dxGeom *geom, Slot slot) {
    if (slot >= m_places.size()) m_places.resize(slot + 1, kNoIndex);
    if (m_places[slot] != kNoIndex) return;
    // A space may never be cleaned while geoms are added and removed.
    if (2 * m_dropped > m_geoms.size()) close();
    m_places[slot] = static_cast<std::uint32_t>(m_geoms.size());
    m_geoms.push_back(geom);
    m_slots.push_back(slot);
}

void dxDirtyQueue::drop(Slot slot) {
    if (slot >= m_places.size() || m_places[slot] == kNoIndex) return;
    m_geoms[m_places[slot]] = nullptr;
    m_places[slot] = kNoIndex;
    ++m_dropped;
}

void dxDirtyQueue::clear() {
    for (std::size_t place = 0; place < m_slots.size(); ++place)
        if (m_geoms[place] != nullptr) m_places[m_slots[place]] = kNoIndex;
    m_geoms.clear();
    m_slots.clear();
    m_dropped = 0;
}

const std::vector<dxGeom *> &dxDirtyQueue::geoms() {
    if (m_dropped != 0) close();
    return m_geoms;
}

// The gaps that dropped members have left.
void dxDirtyQueue::close() {
    std::size_t to = 0;
    for (std::size_t from = 0; from < m_geoms.size(); ++from) {
        if (m_geoms[from] == nullptr) continue;
        m_places[m_slots[from]] = static_cast<std::uint32_t>(to);
        m_geoms[to] = m_geoms[from];
        m_slots[to++] = m_slots[from];
    }
    m_geoms.resize(to);
    m_slots.resize(to);
    m_dropped = 0;
}
