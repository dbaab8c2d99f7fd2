// Problems that workers solve, of steps that are under way, and what becomes of them.
//
// Each outcome is counted when the step takes the problem, so that one that is late and comes nevertheless, before this process begins with it,
// is solved. Those of steps that end early are not counted.
//
// Threading: under the lock of dxRemoteWorkers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <list>
#include <numeric>
#include <vector>

#include "remote/transport/dxRemoteFrame.h"

// The number of a problem: that of its step above, its index among the step's problems below.
constexpr unsigned kRemoteIndexBits = 32;

constexpr std::uint64_t dxRemoteNumber(std::uint64_t batch, unsigned index) { return batch << kRemoteIndexBits | index; }
constexpr std::uint64_t dxRemoteBatchOf(std::uint64_t number) { return number >> kRemoteIndexBits; }
constexpr unsigned dxRemoteIndexOf(std::uint64_t number) { return static_cast<unsigned>(number & ((std::uint64_t{1} << kRemoteIndexBits) - 1)); }

// Of a problem that was sent. All but the first: solved by this process after all.
enum class dxRemoteOutcome {
    Solved,    // by the worker
    Sooner,    // this process had nothing left to do, and was predicted to be sooner
    Late,      // the worker was late
    Lost,      // the worker was lost
    NoResult,  // the worker had none: an error, or no memory there or for a message
    Count
};

class dxRemoteOutcomes {
public:
    std::uint64_t &operator[](dxRemoteOutcome outcome) { return m_counts[static_cast<std::size_t>(outcome)]; }
    std::uint64_t operator[](dxRemoteOutcome outcome) const { return m_counts[static_cast<std::size_t>(outcome)]; }

    std::uint64_t solved() const { return m_counts[0]; }
    std::uint64_t returned() const { return std::accumulate(m_counts.begin() + 1, m_counts.end(), std::uint64_t{0}); }

private:
    std::array<std::uint64_t, static_cast<std::size_t>(dxRemoteOutcome::Count)> m_counts{};
};

struct dxRemoteProblem {
    // Returned: by a worker, with a result. Reclaimed: this process has to solve it.
    enum class State { Expected, Queued, Sent, Returned, Reclaimed, Done };

    std::uint64_t number = 0;
    double cost = 0;  // ns in this process
    State state = State::Expected;
    unsigned worker = 0;
    bool isPatient = false;  // this process has nothing better to do than to wait for it
    bool isSent = false;
    dxRemoteOutcome outcome = dxRemoteOutcome::Solved;  // of one that was sent and reclaimed: why
    dxRemoteBytes bytes;                                // the problem, until it is sent; then the result
};

// Those of one step.
struct dxRemoteProblems {
    std::uint64_t number = 0;  // the upper half of each problem's
    std::vector<dxRemoteProblem> all;
    std::vector<unsigned> returned, reclaimed;  // indices, with room for all that may come; some more than once
    dxRemoteOutcomes outcomes;                  // of those that the step has taken
};
