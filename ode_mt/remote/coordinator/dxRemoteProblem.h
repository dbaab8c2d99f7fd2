// Problems of steps in progress that workers solve, and their outcomes.
//
// Each outcome is counted when the step takes the problem. So a problem that is late, but whose result arrives before this process begins with it,
// counts as solved. Problems of steps that end early are not counted.
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

// The outcome of a problem that was sent. In all cases but the first, this process has solved it.
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
    bool isPatient = false;  // this process has no other work and waits for it
    bool isSent = false;
    dxRemoteOutcome outcome = dxRemoteOutcome::Solved;  // of a problem that was sent and reclaimed: the reason
    dxRemoteBytes bytes;                                // the problem, until it is sent; then the result
};

// The problems of one step.
struct dxRemoteProblems {
    std::uint64_t number = 0;  // the upper half of each problem's
    std::vector<dxRemoteProblem> all;
    std::vector<unsigned> returned, reclaimed;  // indices, with room for all that may come; some more than once
    dxRemoteOutcomes outcomes;                  // of those that the step has taken
};
