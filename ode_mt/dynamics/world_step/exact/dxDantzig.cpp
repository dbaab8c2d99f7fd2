#include "dynamics/world_step/exact/dxDantzig.h"

#include <ode/odemath.h>

#include <cfenv>
#include <cmath>

#include "dynamics/step/islands/dxWorkingMemory.h"
#include "dynamics/world_step/exact/dxDantzigRun.h"
#include "dynamics/world_step/exact/dxUpstreamLcp.h"

namespace {

// Unused lanes may raise them where upstream does not.
constexpr int kCheckedExceptions = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;

// Below this many rows there are few zeros to skip.
constexpr unsigned kSparseRows = 64;

// Zeros may be skipped as long as everything is finite, and sums that start at 0 never become -0. The run sees whether the matrix is.
bool maySkipZeros(const dxDantzigProblem &problem) {
    if (problem.n < kSparseRows || std::fegetround() != FE_TONEAREST) return false;
    for (unsigned i = 0; i < problem.n; ++i)
        if (!std::isfinite(problem.pairsBX[std::size_t(i) * PBX__MAX + PBX_B])) return false;
    return true;
}

bool areLimitsSound(const dReal *pairsLoHi, unsigned n) {
    for (unsigned i = 0; i < n; ++i, pairsLoHi += PLH__MAX)
        if (!(pairsLoHi[PLH_LO] <= 0 && pairsLoHi[PLH_HI] >= 0)) return false;
    return true;
}

// Floating-point exceptions that are raised while it lives, and forgotten then.
class LoweredFlags {
public:
    LoweredFlags() : m_before(std::fetestexcept(kCheckedExceptions)) {
        if (m_before == 0) return;
        std::fegetexceptflag(&m_flags, kCheckedExceptions);
        std::feclearexcept(kCheckedExceptions);
    }
    ~LoweredFlags() {
        if (isAnyRaised()) std::feclearexcept(kCheckedExceptions);
        if (m_before != 0) std::fesetexceptflag(&m_flags, kCheckedExceptions);
    }
    LoweredFlags(const LoweredFlags &) = delete;
    LoweredFlags &operator=(const LoweredFlags &) = delete;
    bool isAnyRaised() const { return std::fetestexcept(kCheckedExceptions) != 0; }

private:
    const int m_before;
    std::fexcept_t m_flags{};
};

enum class Outcome { Solved, GaveUp, LeftToUpstream };

// Nothing is changed if the problem is left to upstream. `limits`: null, or where those are written under which x is a solution.
// `failedLength` is the length of the step that was not positive.
Outcome solve(dxLargeIslandWorkers *islandWorkers, dxWorldProcessMemArena *memory, const dxDantzigProblem &problem, dReal *limits,
              dReal &failedLength) {
    // Beside the world's arena, whose size upstream decides and the user's allocator sees.
    const dxArenaLease more(dxDantzigRun::memory(problem.n));
    if (!more.get()) return Outcome::LeftToUpstream;
    const LoweredFlags flags;
    dxDantzigRun run(islandWorkers, memory, more.get(), problem, maySkipZeros(problem));
    run.solve();
    if (flags.isAnyRaised() || run.isUnfit()) return Outcome::LeftToUpstream;
    run.deliver();
    if (limits != nullptr) run.deliverLimits(limits);
    failedLength = run.failedLength();
    return run.hasFailed() ? Outcome::GaveUp : Outcome::Solved;
}

// As far as ours may.
Outcome trySolve(dxLargeIslandWorkers *islandWorkers, dxWorldProcessMemArena *memory, const dxDantzigProblem &problem, dReal *limits,
                 dReal &failedLength) {
    if (fegetexcept() != 0 || !areLimitsSound(problem.pairsLoHi, problem.n)) return Outcome::LeftToUpstream;
    void *const start = memory->SaveState();
    const Outcome outcome = solve(islandWorkers, memory, problem, limits, failedLength);
    memory->RestoreState(start);
    return outcome;
}

}  // namespace

void dxSolveDantzig(dxLargeIslandWorkers *islandWorkers, dxWorldProcessMemArena *memory, unsigned n, dReal *A, dReal *pairsBX, dReal *w,
                    unsigned bilateral, dReal *pairsLoHi, int *normalOf) {
    Outcome outcome = Outcome::LeftToUpstream;
    dReal failedLength = 0;
    if (bilateral < n && w == nullptr)
        outcome = trySolve(islandWorkers, memory, {n, A, pairsBX, bilateral, pairsLoHi, normalOf}, nullptr, failedLength);
    if (outcome == Outcome::LeftToUpstream) {
        dxSolveLCP(memory, n, A, pairsBX, w, bilateral, pairsLoHi, normalOf);
    } else if (outcome == Outcome::GaveUp) {
        dMessage(d_ERR_LCP, "LCP internal error, s <= 0 (s=%.4e)", static_cast<double>(failedLength));
    }
}

bool dxTryDantzig(dxLargeIslandWorkers *islandWorkers, dxWorldProcessMemArena *memory, unsigned n, dReal *A, dReal *pairsBX, dReal *pairsLoHi,
                  int *normalOf) {
    dReal failedLength = 0;
    return trySolve(islandWorkers, memory, {n, A, pairsBX, 0, pairsLoHi, normalOf}, pairsLoHi, failedLength) == Outcome::Solved;
}
