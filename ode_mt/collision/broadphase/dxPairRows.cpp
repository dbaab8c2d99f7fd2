#include "collision/broadphase/dxPairRows.h"

void dxPairRows::clear() {
    m_geoms.clear();
    m_slots.clear();
    m_filters.clear();
    m_boxes.clear();
    m_mayExclude = false;
    m_comparisons = m_overlaps = 0;
}

void dxPairRows::finish() {
    if (m_found.size() < geoms()) m_found.resize(geoms());
}

std::size_t dxPairRows::find(std::size_t row) { return keepAgreeing(row, findFrom(row + 1, m_boxes, m_boxes.row(row))); }

// Without a branch on what the filters say: where they exclude about half of the pairs it would be mispredicted.
std::size_t dxPairRows::keepOnlyAgreeing(const dxPairFilter &filter, std::size_t count) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t element = m_found[i];
        m_found[kept] = element;
        kept += dxFiltersAgree(filter, m_filters[element]);
    }
    return kept;
}
