#include "dynamics/step/random/dxReservedDraws.h"

#include "dynamics/step/random/dxRandom.h"

std::uint32_t dxReservedDraws::takeBlock(std::uint64_t draws) {
    const std::uint32_t before = m_seed;
    m_seed = dxRandom::jump(m_seed, draws);
    return before;
}

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
