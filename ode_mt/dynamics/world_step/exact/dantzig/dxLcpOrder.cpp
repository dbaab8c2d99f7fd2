#include "dynamics/world_step/exact/dantzig/dxLcpOrder.h"

#include <cstddef>
#include <utility>

#include "dynamics/world_step/exact/dantzig/dxUpstreamLcp.h"

namespace {

bool isUnbounded(const dxDantzigProblem &problem, unsigned row) {
    if (problem.normalOf && problem.normalOf[row] >= 0) return false;  // its limits are set later
    const dReal *limits = problem.pairsLoHi + std::size_t(row) * PLH__MAX;
    return limits[PLH_LO] == -dInfinity && limits[PLH_HI] == dInfinity;
}

}  // namespace

unsigned dxFindLcpOrder(const dxDantzigProblem &problem, unsigned *order) {
    for (unsigned i = 0; i < problem.n; ++i) order[i] = i;
    unsigned unbounded = problem.unbounded;
    for (unsigned i = unbounded; i < problem.n; ++i)
        if (isUnbounded(problem, order[i])) std::swap(order[unbounded++], order[i]);
    if (!problem.normalOf) return unbounded;
    unsigned end = problem.n;
    for (unsigned i = problem.n; i-- > unbounded;)
        if (problem.normalOf[order[i]] >= 0) std::swap(order[i], order[--end]);
    return unbounded;
}
