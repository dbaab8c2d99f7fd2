#include "dynamics/lcp/dxDantzig.h"

#include <ode/odemath.h>

#include <algorithm>
#include <cfenv>

// Upstream's headers do not include what they use.
#include "config.h"

#include "error.h"
#include "lcp.h"
#include "matrix.h"
#include "util.h"

#include "dynamics/lcp/dxDantzigRun.h"

namespace {

// Lanes that nobody asked for may raise them where upstream does not.
constexpr int kTelling = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;

bool areLimitsSound(const dReal *pairsLoHi, unsigned n) {
    for (unsigned i = 0; i < n; ++i, pairsLoHi += PLH__MAX)
        if (!(pairsLoHi[PLH_LO] <= 0 && pairsLoHi[PLH_HI] >= 0)) return false;
    return true;
}

// False, with nothing changed, if upstream's solver is to be asked.
bool solve(dxWorldProcessMemArena *memory, const dxDantzigProblem &problem) {
    const int before = std::fetestexcept(kTelling);
    dxDantzigRun run(memory, problem);
    run.solve();
    const int raised = std::fetestexcept(kTelling) & ~before;
    if (raised != 0) {
        std::feclearexcept(raised);
        return false;
    }
    run.deliver();
    return true;
}

}  // namespace

void dxSolveDantzig(dxWorldProcessMemArena *memory, unsigned n, dReal *A, dReal *pairsBX, dReal *w,
                    unsigned unbounded, dReal *pairsLoHi, int *normalOf) {
    const bool isOurs = unbounded < n && w == nullptr && fegetexcept() == 0 && areLimitsSound(pairsLoHi, n);
    if (isOurs) {
        void *const start = memory->SaveState();
        const bool isSolved = solve(memory, {n, A, pairsBX, unbounded, pairsLoHi, normalOf});
        memory->RestoreState(start);
        if (isSolved) return;
    }
    dxSolveLCP(memory, n, A, pairsBX, w, unbounded, pairsLoHi, normalOf);
}

std::size_t dxDantzigMemory(unsigned n, bool givenW) {
    return std::max<std::size_t>(dxEstimateSolveLCPMemoryReq(n, givenW), dxDantzigRun::memory(n));
}
