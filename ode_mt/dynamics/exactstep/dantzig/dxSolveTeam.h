// The workers of an exact step's island, for parts of its LCP that are large enough: some ten microseconds.
//
// Whether that pays is measured (dxSharingPolicy), on the transposed solves, of which each push has one: on a machine that is
// busy with other things workers come late. Results are the same either way.
#pragma once

#include <chrono>
#include <cstddef>

#include "dynamics/islands/dxIslandTeam.h"

class dxSolveTeam {
public:
    // `team`: null for the calling thread alone.
    explicit dxSolveTeam(dxIslandTeam *team) : m_team(team), m_isSharing(team != nullptr && team->sharesAlways) {}

    // Returns the runner for work on this number of matrix elements; null: the calling thread alone.
    dxTaskRunner *runnerFor(std::size_t elements) const {
        return m_isSharing && elements >= least() ? m_team->runner : nullptr;
    }

    // Calls solve(runner) for a triangle of so many elements, with a runner as above.
    template <class Solve>
    void solveTriangle(std::size_t elements, Solve solve) {
        if (m_team == nullptr || elements < least()) return solve(nullptr);
        if (m_team->sharesAlways) return solve(m_team->runner);
        m_isSharing = m_team->solvePolicy.shouldShare();
        const auto start = std::chrono::steady_clock::now();
        solve(m_isSharing ? m_team->runner : nullptr);
        const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
        m_team->solvePolicy.remember(m_isSharing, time.count() * kElementsOfReference / static_cast<double>(elements));
    }

private:
    // Units: elements; some 10 us, as starting and ending a run takes one. The lower value is for tests, which always
    // run in parallel.
    static constexpr std::size_t kLeastElements = 80'000, kLeastAlways = 8'000;
    std::size_t least() const { return m_team->sharesAlways ? kLeastAlways : kLeastElements; }

    // Times are remembered as those of a triangle of 1000 rows.
    static constexpr double kElementsOfReference = 500'000;

    dxIslandTeam *const m_team;
    bool m_isSharing;
};
