#include "dynamics/lcp/dxDantzig.h"

#include <ode/odemath.h>

#include <cfenv>

#include "dynamics/dxWorkingMemory.h"
#include "dynamics/lcp/dxDantzigRun.h"
#include "dynamics/lcp/dxUpstreamLcp.h"

namespace {

// Lanes that nobody asked for may raise them where upstream does not.
constexpr int kTelling = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;

bool areLimitsSound(const dReal *pairsLoHi, unsigned n) {
    for (unsigned i = 0; i < n; ++i, pairsLoHi += PLH__MAX)
        if (!(pairsLoHi[PLH_LO] <= 0 && pairsLoHi[PLH_HI] >= 0)) return false;
    return true;
}

// Memory beside the world's arena, whose size upstream decides and the user's allocator sees.
class BorrowedArena {
public:
    explicit BorrowedArena(std::size_t size) : m_arena(dxWorkingMemory::take(size)) {}
    ~BorrowedArena() {
        if (m_arena) dxWorkingMemory::giveBack(m_arena);
    }
    BorrowedArena(const BorrowedArena &) = delete;
    BorrowedArena &operator=(const BorrowedArena &) = delete;
    dxWorldProcessMemArena *get() const { return m_arena; }

private:
    dxWorldProcessMemArena *const m_arena;
};

enum class Outcome { Solved, GaveUp, LeftToUpstream };

// Nothing is changed if the problem is left to upstream. `failedLength`: of the push that could not be made.
Outcome solve(dxWorldProcessMemArena *memory, const dxDantzigProblem &problem, dReal &failedLength) {
    const BorrowedArena more(dxDantzigRun::memory(problem.n));
    if (!more.get()) return Outcome::LeftToUpstream;
    const int before = std::fetestexcept(kTelling);
    dxDantzigRun run(memory, more.get(), problem);
    run.solve();
    const int raised = std::fetestexcept(kTelling) & ~before;
    if (raised != 0) {
        std::feclearexcept(raised);
        return Outcome::LeftToUpstream;
    }
    run.deliver();
    failedLength = run.failedLength();
    return run.hasFailed() ? Outcome::GaveUp : Outcome::Solved;
}

}  // namespace

void dxSolveDantzig(dxWorldProcessMemArena *memory, unsigned n, dReal *A, dReal *pairsBX, dReal *w,
                    unsigned unbounded, dReal *pairsLoHi, int *normalOf) {
    Outcome outcome = Outcome::LeftToUpstream;
    dReal failedLength = 0;
    if (unbounded < n && w == nullptr && fegetexcept() == 0 && areLimitsSound(pairsLoHi, n)) {
        void *const start = memory->SaveState();
        outcome = solve(memory, {n, A, pairsBX, unbounded, pairsLoHi, normalOf}, failedLength);
        memory->RestoreState(start);
    }
    if (outcome == Outcome::LeftToUpstream) {
        dxSolveLCP(memory, n, A, pairsBX, w, unbounded, pairsLoHi, normalOf);
    } else if (outcome == Outcome::GaveUp) {
        dMessage(d_ERR_LCP, "LCP internal error, s <= 0 (s=%.4e)", static_cast<double>(failedLength));
    }
}
