#include "dynamics/world_step/exact/dxDantzigArrays.h"

#include <algorithm>

#include "dynamics/world_step/exact/dxFactorRemoval.h"
#include "dynamics/world_step/exact/dxForwardSolves.h"
#include "dynamics/world_step/exact/dxIndexSets.h"
#include "dynamics/world_step/exact/dxLcpMatrix.h"
#include "dynamics/world_step/kernels/dxFactorLDLT.h"

namespace {

// For removing a row from the factorisation, and for making it.
std::size_t temporarySize(unsigned n) { return std::max(dxFactorRemovalStorage(n), dxFactorLDLTStorage(n)); }

std::size_t halfBlockCount(unsigned n) { return 2 * (dxLcpBlock(n) + std::size_t(1)); }

}  // namespace

dxDantzigArrays::dxDantzigArrays(dxArrayTaker &taker, unsigned n, unsigned bilateral)
    : matrix(taker.take<dReal>(dxLcpMatrix::size(n))),
      sets(taker.take<unsigned>(dxIndexSets::kWords * std::size_t(n))),
      factorRows(taker.take<dReal *>(n)),
      diagonal(taker.take<dReal>(n)),
      begins(taker.take<unsigned>(n)),
      solutions(taker.take<dReal>(dxForwardSolves::size(n, bilateral))),
      solutionWords(taker.take<unsigned>(dxForwardSolves::words(n))),
      b(taker.take<dReal>(n)),
      x(taker.take<dReal>(n)),
      w(taker.take<dReal>(n)),
      deltaW(taker.take<dReal>(dxLcpRoundUp(n))),
      limits(taker.take<dxLimitPair>(n)),
      side(taker.take<dReal>(n)),
      leaving(taker.take<unsigned>(n)),
      halfBlockN(taker.take<unsigned>(halfBlockCount(n))),
      deltaX(taker.take<dReal>(n)),
      solved(taker.take<dReal>(n)),
      temporary(taker.take<dReal>(temporarySize(n))) {}

dxDantzigArrays dxDantzigArrays::take(dxWorldProcessMemArena *arena, unsigned n, unsigned bilateral) {
    dxArrayTaker taker(arena);
    const dxDantzigArrays arrays(taker, n, bilateral);
    std::fill_n(arrays.halfBlockN, halfBlockCount(n), 0u);
    return arrays;
}

std::size_t dxDantzigArrays::memory(unsigned n) {
    dxArrayTaker sizes;
    const dxDantzigArrays none(sizes, n, 0);
    return sizes.bytes();
}
