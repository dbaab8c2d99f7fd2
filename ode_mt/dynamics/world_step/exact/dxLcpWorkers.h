// The workers of an exact step's island, for parts of its LCP that are large enough: some ten microseconds.
//
// Whether that pays is measured (dxSharingPolicy), on the transposed solves, of which each push has one: on a machine that is
// busy with other things workers come late. Results are the same either way.
#pragma once

#include <cstddef>

#include "core/dxStopwatch.h"
#include "dynamics/step/islands/dxIslandStep.h"

class dxLcpWorkers {
public:
    // `islandWorkers`: null for the calling thread alone.
    explicit dxLcpWorkers(dxLargeIslandWorkers *islandWorkers)
        : m_islandWorkers(islandWorkers), m_isSharing(islandWorkers != nullptr && islandWorkers->isAlwaysParallel) {}

    // Returns the runner for work on this number of matrix elements; null: the calling thread alone.
    dxTaskRunner *runnerFor(std::size_t elements) const {
        return m_isSharing && elements >= least() ? m_islandWorkers->runner : nullptr;
    }

    // Calls solve(runner) for a triangle of `elements` elements, with a runner as above.
    template <class Solve>
    void solveTriangle(std::size_t elements, Solve solve) {
        if (m_islandWorkers == nullptr || elements < least()) return solve(nullptr);
        if (m_islandWorkers->isAlwaysParallel) return solve(m_islandWorkers->runner);
        m_isSharing = m_islandWorkers->solvePolicy.shouldShare();
        const dxStopwatch stopwatch;
        solve(m_isSharing ? m_islandWorkers->runner : nullptr);
        m_islandWorkers->solvePolicy.record(m_isSharing, stopwatch.ns() * kElementsOfReference / static_cast<double>(elements));
    }

private:
    // Units: elements; some 10 us, as starting and ending a run takes one. The lower value is for tests, which always
    // run in parallel.
    static constexpr std::size_t kMinElements = 80'000, kMinAlways = 8'000;
    std::size_t least() const { return m_islandWorkers->isAlwaysParallel ? kMinAlways : kMinElements; }

    // Times are remembered as those of a triangle of 1000 rows.
    static constexpr double kElementsOfReference = 500'000;

    dxLargeIslandWorkers *const m_islandWorkers;
    bool m_isSharing;
};
