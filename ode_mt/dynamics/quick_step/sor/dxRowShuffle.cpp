#include "dynamics/quick_step/sor/dxRowShuffle.h"

#include <utility>

#include "dynamics/step/random/dxIslandDraws.h"
#include "dynamics/step/random/dxRandom.h"

void dxShuffleRows(int *order, unsigned rows) {
    if (rows < 2) return;
    std::uint32_t seed = dxTakeIslandDraws(rows - 1);
    for (unsigned i = 1; i < rows; ++i) {
        seed = dxRandom::next(seed);
        std::swap(order[i], order[dxRandom::toRange(seed, i + 1)]);
    }
}
