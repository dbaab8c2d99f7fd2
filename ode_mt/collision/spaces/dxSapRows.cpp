#include "collision/spaces/dxSapRows.h"

#include <algorithm>
#include <numeric>

void dxSapRows::clear(std::size_t swept) {
    dxPairRows::clear();
    m_columns.resize(swept);
}

void dxSapRows::pushSwept(dxGeom *geom, Slot slot, const dxPairFilter &filter, const dxSapBox &box) {
    m_columns.set(geoms(), box);
    pushElement(geom, slot, filter);
}

void dxSapRows::finish(const std::vector<std::uint32_t> &places) {
    m_places = places;
    makeRoom();
}

std::size_t dxSapRows::find(std::size_t row) {
    std::size_t count;
    if (row < m_columns.size()) {
        const dxSapMeetings meetings = m_meetBehind(m_columns, row, m_found.data());
        countWork(meetings.compared, meetings.rows);
        count = meetings.rows;
    } else {
        count = pairInfinite(row);
        countWork(count, count);
    }
    return keepAgreeing(row, count);
}

// Boxes are not compared.
std::size_t dxSapRows::pairInfinite(std::size_t row) {
    const auto behind = m_found.begin() + static_cast<std::ptrdiff_t>(geoms() - row - 1);
    std::iota(m_found.begin(), behind, static_cast<std::uint32_t>(row + 1));
    return static_cast<std::size_t>(std::copy(m_places.begin(), m_places.end(), behind) - m_found.begin());
}
