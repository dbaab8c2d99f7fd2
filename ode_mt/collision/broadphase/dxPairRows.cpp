#include "collision/broadphase/dxPairRows.h"

void dxPairRows::clear() {
    m_elements.clear();
    m_filters.clear();
    m_listed.clear();
    m_boxes.clear();
    m_mayExclude = false;
    m_comparisons = m_overlaps = 0;
}

void dxPairRows::makeRoom() {
    if (m_found.size() < geoms()) m_found.resize(geoms());
}

std::size_t dxPairRows::find(std::size_t row) { return keepAgreeing(row, findFrom(row + 1, m_boxes, box(row))); }

// Branch-free in the result of the filters: where they exclude about half of the pairs, a branch would be mispredicted.
std::size_t dxPairRows::keepOnlyAgreeing(const dxPairFilter &filter, std::size_t count) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t element = m_found[i];
        m_found[kept] = element;
        kept += dxFiltersAgree(filter, m_filters[element]);
    }
    return kept;
}
