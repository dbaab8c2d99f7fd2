#include "dynamics/dxReservedDraws.h"

#include "dynamics/dxRandom.h"

std::uint32_t dxReservedDraws::draw() { return m_seed = dxRandom::next(m_seed); }

bool dxReservedDraws::takeOver(dxReport, int, const char *, va_list) {
    giveBack();
    return false;
}

void dxReservedDraws::giveBack() {
    if (m_givenBack) return;
    m_givenBack = true;
    dxRandom::rewindShared(m_end, m_seed);
    leave();
}
