#include "dynamics/step/random/dxIslandDraws.h"

#include "dynamics/step/random/dxRandom.h"

std::uint32_t dxTakeIslandDraws(std::uint64_t draws) {
    dxUpstreamScope *const scope = dxUpstreamScope::current();
    return scope != nullptr ? scope->takeBlock(draws) : dxRandom::takeSharedBlock(draws);
}

int dxDrawForIsland(int range) {
    return dxRandom::toRange(dxRandom::next(dxTakeIslandDraws(1)), static_cast<std::uint32_t>(range));
}

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
