#include "dynamics/world_step/exact/dxIndexSets.h"

#include <algorithm>
#include <utility>

dxIndexSets::dxIndexSets(unsigned n, unsigned bilateral, unsigned *storage)
    : m_countC(bilateral),
      m_inPlace(n),
      m_indexAt(storage),
      m_factorIndex(storage + n),
      m_factorPosition(storage + 2 * n) {
    for (unsigned i = 0; i < n; ++i) m_indexAt[i] = i;
    for (unsigned i = 0; i < bilateral; ++i) m_factorIndex[i] = m_factorPosition[i] = i;
}

void dxIndexSets::moveFromNToC(unsigned position) {
    --m_countN;
    moveToC(position);
}

// The position after those of C is taken; its previous index moves to the free one.
void dxIndexSets::moveToC(unsigned position) {
    if (position != m_countC) m_inPlace = std::min(m_inPlace, m_countC);
    std::swap(m_indexAt[m_countC], m_indexAt[position]);
    m_factorIndex[m_countC] = m_indexAt[m_countC];
    m_factorPosition[m_countC] = m_countC;
    ++m_countC;
}

unsigned dxIndexSets::factorRowAt(unsigned position) const {
    return static_cast<unsigned>(std::find(m_factorPosition, m_factorPosition + m_countC, position) -
                                 m_factorPosition);
}

// The last index of C takes the position that becomes free.
void dxIndexSets::moveFromCToN(unsigned position, unsigned factorRow) {
    const unsigned last = m_countC - 1;
    m_inPlace = std::min({m_inPlace, position, factorRow});
    m_factorPosition[factorRowAt(last)] = position;
    std::copy(m_factorPosition + factorRow + 1, m_factorPosition + m_countC, m_factorPosition + factorRow);
    std::copy(m_factorIndex + factorRow + 1, m_factorIndex + m_countC, m_factorIndex + factorRow);
    std::swap(m_indexAt[position], m_indexAt[last]);
    --m_countC;
    ++m_countN;
}
