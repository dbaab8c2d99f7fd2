// What becomes of problems that were sent to a worker, counted: of a step, and of the process.
//
// Each is counted when the step takes it, so that one that is late and comes nevertheless, before home begins with it, is solved. Those of steps that
// end early are not counted.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>

enum class dxRemoteOutcome {
    Solved,    // by the worker
    Sooner,    // taken back by home, which had nothing left to do
    Late,      // solved at home, as the worker was late
    Lost,      // likewise, as it was lost
    NoResult,  // likewise, as it had none: an error, or no memory there or for a message
    Count
};

class dxRemoteOutcomes {
public:
    std::uint64_t &operator[](dxRemoteOutcome outcome) { return m_counts[static_cast<std::size_t>(outcome)]; }
    std::uint64_t operator[](dxRemoteOutcome outcome) const { return m_counts[static_cast<std::size_t>(outcome)]; }

    std::uint64_t solved() const { return m_counts[0]; }
    // At home after all.
    std::uint64_t returned() const { return std::accumulate(m_counts.begin() + 1, m_counts.end(), std::uint64_t{0}); }

private:
    std::array<std::uint64_t, static_cast<std::size_t>(dxRemoteOutcome::Count)> m_counts{};
};
