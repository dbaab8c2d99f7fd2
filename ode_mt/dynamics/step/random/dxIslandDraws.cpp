#include "dynamics/step/random/dxIslandDraws.h"

#include "dynamics/step/random/dxRandom.h"
#include "threading/dxUpstreamScope.h"

std::uint32_t dxTakeIslandDraws(std::uint64_t draws) {
    dxUpstreamScope *const scope = dxUpstreamScope::current();
    return scope != nullptr ? scope->takeBlock(draws) : dxRandom::takeSharedBlock(draws);
}

int dxDrawForIsland(int range) {
    return dxRandom::toRange(dxRandom::next(dxTakeIslandDraws(1)), static_cast<std::uint32_t>(range));
}
