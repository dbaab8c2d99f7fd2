// Sweeps over the phases of a plan, on one thread or on an island's workers, with the same results.
//
// Phases follow one another; the chunks of a phase may be taken in any order by any thread. Workers begin with their own share of
// a phase's chunks, the same in each sweep, so that what they read lies in their caches, and then help others. Who ends the last
// chunk opens the next phase. A worker waits only for chunks that running threads hold, so any number of them finishes, one
// included.
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "dynamics/quick_step/fast/dxConstraintPlan.h"
#include "threading/dxPerturbation.h"
#include "threading/dxTaskRunner.h"
#include "threading/pool/dxSpin.h"

class dxColoredSweeps {
public:
    // At most so many sweeps; Throws std::bad_alloc.
    void begin(const dxConstraintPlan &plan, unsigned most);

    // Takes as much memory as others have. Throws std::bad_alloc.
    void reserveAs(const dxColoredSweeps &other) { reserve(other.m_claimCount); }

    // Calls solve(chunk, sweep) for all chunks in sweeps 0, 1, ...; it returns an energy. After each sweep isLast(sweep, sum of
    // the energies) is asked once. Returns the number of sweeps.
    template <class Solve, class IsLast>
    unsigned run(dxTaskRunner &runner, const Solve &solve, const IsLast &isLast) {
        const unsigned workers = runner.workers();
        if (workers < 2 || m_chunkCount < m_phaseCount + kMinBeside) return runAlone(solve, isLast);
        runner.forBlocks(dxParallelStage::ColoredSweeps, workers,
                         [&](unsigned share, unsigned) { takePart(share, workers, solve, isLast); });
        return m_end.load(std::memory_order_relaxed) / m_phaseCount;
    }

private:
    // Where phases have fewer chunks beside their first ones, a sweep is done before another worker could begin.
    static constexpr unsigned kMinBeside = 4;

    void reserve(unsigned chunks);

    template <class Solve, class IsLast>
    unsigned runAlone(const Solve &solve, const IsLast &isLast) {
        for (unsigned sweep = 0; sweep < m_most; ++sweep) {
            for (unsigned chunk = 0; chunk < m_chunkCount; ++chunk) m_energies[chunk] = solve(chunk, sweep);
            if (isLast(sweep, energy())) return sweep + 1;
        }
        return m_most;
    }

    template <class Solve, class IsLast>
    void takePart(unsigned share, unsigned workers, const Solve &solve, const IsLast &isLast) {
        for (unsigned position = m_position.load(std::memory_order_acquire); position < m_end.load(std::memory_order_acquire);
             position = m_position.load(std::memory_order_acquire)) {
            const unsigned sweep = position / m_phaseCount, phase = position % m_phaseCount;
            const unsigned first = m_phases[phase].firstChunk, count = m_phases[phase].endChunk - first;
            const unsigned own = static_cast<unsigned>(std::uint64_t(share) * count / workers);
            for (unsigned i = 0; i < count; ++i) {
                const unsigned chunk = first + (own + i) % count;
                if (!claim(chunk, sweep)) continue;
                m_energies[chunk] = solve(chunk, sweep);
                if (m_finished.fetch_add(1, std::memory_order_acq_rel) + 1 == count) open(position, isLast);
            }
            await(position);
        }
    }

    bool claim(unsigned chunk, unsigned sweep) {
        unsigned expected = sweep;
        dxPerturb(dxSchedulePoint::ClaimChunk);
        return m_claims[chunk].load(std::memory_order_relaxed) == sweep &&
               m_claims[chunk].compare_exchange_strong(expected, sweep + 1, std::memory_order_relaxed);
    }

    template <class IsLast>
    void open(unsigned position, const IsLast &isLast) {
        dxPerturb(dxSchedulePoint::OpenPhase);
        m_finished.store(0, std::memory_order_relaxed);
        const unsigned next = position + 1;
        if (next % m_phaseCount == 0 && isLast(position / m_phaseCount, energy())) m_end.store(next, std::memory_order_relaxed);
        m_position.store(next, std::memory_order_release);
    }

    void await(unsigned position) const {
        if (m_position.load(std::memory_order_acquire) == position) dxPerturb(dxSchedulePoint::AwaitPhase);
        dxAwait([&] { return m_position.load(std::memory_order_acquire) != position; });
    }

    // In the order of the chunks, whoever solved them.
    double energy() const {
        double sum = 0;
        for (unsigned chunk = 0; chunk < m_chunkCount; ++chunk) sum += m_energies[chunk];
        return sum;
    }

    const dxConstraintPlan::Phase *m_phases = nullptr;
    unsigned m_chunkCount = 0, m_phaseCount = 0, m_most = 0;
    std::vector<double> m_energies;                     // by chunk
    std::unique_ptr<std::atomic<unsigned>[]> m_claims;  // by chunk: sweeps in which it was taken
    unsigned m_claimCount = 0;
    alignas(64) std::atomic<unsigned> m_position{0};  // phases that have been solved, in all sweeps
    std::atomic<unsigned> m_end{0};
    alignas(64) std::atomic<unsigned> m_finished{0};  // chunks of this phase
};
