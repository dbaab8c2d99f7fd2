#include "dynamics/quickstep/sor/dxRowShuffle.h"

#include <utility>

#include "dynamics/random/dxRandom.h"
#include "threading/dxUpstreamScope.h"

void dxShuffleRows(int *order, unsigned rows) {
    if (rows < 2) return;
    dxUpstreamScope *const scope = dxUpstreamScope::current();
    std::uint32_t seed = scope ? scope->takeBlock(rows - 1) : dxRandom::takeSharedBlock(rows - 1);
    for (unsigned i = 1; i < rows; ++i) {
        seed = dxRandom::next(seed);
        std::swap(order[i], order[dxRandom::toRange(seed, i + 1)]);
    }
}
