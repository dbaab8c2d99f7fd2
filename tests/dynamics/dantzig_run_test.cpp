// A run of Dantzig's algorithm stays within its memory, and raises no exception where upstream raises none: it would be
// right all the same, but upstream's solver would do everything again.
//
// Covers dxDantzigArrays.cpp.
#include <gtest/gtest.h>

#include <cfenv>
#include <string>
#include <vector>

#include "config.h"

#include "lcp.h"
#include "util.h"

#include "dynamics/world_step/exact/dxDantzigRun.h"
#include "instruction_sets.h"
#include "lcp_problem.h"

namespace {

class Arena {
public:
    explicit Arena(std::size_t size) : m_arena(dxAllocateTemporaryWorldProcessMemArena(size, nullptr, nullptr)) {
        m_arena->ResetState();
        m_start = static_cast<char *>(m_arena->SaveState());
    }
    ~Arena() { dxFreeTemporaryWorldProcessMemArena(m_arena); }
    Arena(const Arena &) = delete;
    Arena &operator=(const Arena &) = delete;

    dxWorldProcessMemArena *get() const { return m_arena; }
    std::size_t taken() const { return static_cast<std::size_t>(static_cast<char *>(m_arena->SaveState()) - m_start); }

private:
    dxWorldProcessMemArena *const m_arena;
    char *m_start;
};

dxDantzigProblem problemOf(Problem &problem) {
    return {problem.n, problem.A.data(), problem.bx.data(), problem.bilateral, problem.limits.data(), problem.normalOf.data()};
}

}  // namespace

TEST(DantzigRun, TakesNoMoreMemoryThanItSays) {
    constexpr std::size_t kMuchMore = 1 << 22;
    for (unsigned n = 1; n < 700; n += n < 40 || (n > 180 && n < 360) ? 1 : 7) {
        Arena given(dxEstimateSolveLCPMemoryReq(n, false));
        std::vector<dReal> A(std::size_t(n) * dPAD(n), dReal(1)), bx(2 * n), limits;
        for (unsigned i = 0; i < n; ++i) limits.insert(limits.end(), {dReal(-1), dReal(1)});
        for (unsigned bilateral = 0; bilateral <= n; bilateral += n < 40 ? 1 : 8) {
            Arena arena(dxDantzigRun::memory(n) + kMuchMore);
            const dxDantzigProblem problem{n, A.data(), bx.data(), bilateral, limits.data(), nullptr};
            given.get()->ResetState();
            const dxDantzigRun run(nullptr, given.get(), arena.get(), problem, true);
            ASSERT_LE(arena.taken(), dxDantzigRun::memory(n)) << n << " rows, " << bilateral << " of them without limits";
        }
    }
}

// Upstream's matrix and what its solver takes; ours comes on top.
TEST(DantzigRun, TakesNoMoreMemoryAgainThanUpstreamButForVectors) {
    constexpr std::size_t kVectors = 30;
    for (unsigned n = 1; n < 3000; n += 1 + n / 50) {
        const std::size_t upstream = std::size_t(n) * dPAD(n) * sizeof(dReal) + dxEstimateSolveLCPMemoryReq(n, false);
        EXPECT_LE(dxDantzigRun::memory(n), upstream + kVectors * (n + kLineLanes) * sizeof(dReal)) << n << " rows";
    }
}

TEST(DantzigRun, StaysWithinItsMemoryAndRaisesNothing) {
    for (const std::int64_t set : instructionSets())
        onInstructionSet(set, [] {
            const Shape shapes[] = {{12, 4, 30, 1e-5, 0, true, false},
                                    {90, 20, 130, 1e-5, 0, true, false},
                                    {300, 0, 400, 1e-5, 0, true, true, 10},
                                    {280, 60, 400, 1e-5, 0, true, false, 10},
                                    {400, 100, 500, 1e-5, 0, true, true}};
            for (const Shape &shape : shapes) {
                Problem problem(shape, 5);
                const dxDantzigProblem asked = problemOf(problem);
                Arena given(dxEstimateSolveLCPMemoryReq(problem.n, false)), arena(2 * dxDantzigRun::memory(problem.n));
                std::feclearexcept(FE_ALL_EXCEPT);
                dxDantzigRun run(nullptr, given.get(), arena.get(), asked, problem.n >= 64);
                run.solve();
                EXPECT_EQ(std::fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW), 0) << problem.n << " rows";
                EXPECT_LE(arena.taken(), dxDantzigRun::memory(problem.n)) << problem.n << " rows";
            }
        });
}
