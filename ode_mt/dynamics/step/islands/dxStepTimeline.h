// The events of a step on the timeline, besides its parallel stages (settings/dxWorkersRunner.h).
//
//   step                      from the search for islands to the last body's move
//     island search           bodies fall asleep, islands get their order
//     island preparation      of islands side by side: survey, blocks, random numbers
//     islands in order        on the calling thread, one after the other; a large one with workers
//       island                of kMinRecorded bodies and joints at least
//         solver              from the rows to the forces or velocities
//     commit                  of islands side by side: what the user and the spaces hear
//
// Threading: the thread that steps the world; of an island, the one that steps the island.
#pragma once

#include <cstdint>

#include <ode/ode.h>

#include "dynamics/step/islands/dxIsland.h"
#include "settings/dxWorldStatistics.h"
#include "threading/timeline/dxTimeline.h"

namespace dxStepEvents {

inline constexpr dxTimelineEvent kIslandSearch{"island search", "step", {}, dxTimelineEvent::Kind::Span, dxFrameStage::IslandSearch};
inline constexpr dxTimelineEvent kIslandPreparation{"island preparation", "step", {}, dxTimelineEvent::Kind::Span, dxFrameStage::IslandPreparation};
inline constexpr dxTimelineEvent kIslandsInOrder{"islands in order", "step", {"islands"}, dxTimelineEvent::Kind::Span, dxFrameStage::Islands};
inline constexpr dxTimelineEvent kCommit{"commit", "step", {}, dxTimelineEvent::Kind::Span, dxFrameStage::Commit};
inline constexpr dxTimelineEvent kIsland{"island", "island", {"bodies", "joints", "rows"}};
inline constexpr dxTimelineEvent kSolver{"solver", "island", {"rows"}};

}  // namespace dxStepEvents

// The event of a whole step. It is made after the search for islands, and begins where beginSearch() was called: before the search, or after it for
// one of many worlds (dxStepWorlds). At its end it writes the counters and, if steps are counted, adds the step to the statistics of its world.
//
// A callback may step another world: the state of the step or collision around that one is kept, and restored at its end. The depth of
// collisions is not: a collision that a callback has left by longjmp would never end.
class dxStepSpan {
public:
    dxStepSpan(const dxWorld *world, unsigned islands) : m_ring(dxTimeline::ofThisThread()), m_world(world) {
        if (m_ring != nullptr) begin(world, islands);
    }
    ~dxStepSpan() {
        if (m_ring != nullptr) end();
    }
    dxStepSpan(const dxStepSpan &) = delete;
    dxStepSpan &operator=(const dxStepSpan &) = delete;

    // Called when a step begins with the search for islands.
    static void beginSearch();

    // Stores reasonOf(threads): why no more threads took part. reasonOf is called only if something is recorded.
    template <class Reason>
    void setReason(const Reason &reasonOf) {
        if (m_ring != nullptr) m_reason = reasonOf(m_ring->threads());
    }

    // Stores recordOf(): what remote workers did. recordOf is called only if the step is counted.
    template <class Record>
    void setRemote(const Record &recordOf) {
        if (m_ring != nullptr && dxTimeline::isCounted()) m_remote = recordOf();
    }

private:
    void begin(const dxWorld *world, unsigned islands);
    void end();
    void goOnWithOuter();

    dxTimelineRing *const m_ring;
    const dxWorld *const m_world;
    unsigned m_islands = 0, m_bodies = 0, m_contacts = 0;
    dODE_MT_Reason m_reason = dODE_MT_REASON_PARALLEL;
    dxRemoteRecord m_remote;
    std::uint64_t m_begin = 0;  // ticks; 0: it is not known
    struct Outer {
        dxFrameTimes times;
        std::uint64_t rows;
        dxTimelineRing::Caller caller;
        unsigned threads;
    } m_outer;  // is set if something is recorded
};

class dxIslandSpan {
public:
    // Smaller islands have no event of their own. Units: bodies and joints.
    static constexpr unsigned kMinRecorded = 16;

    explicit dxIslandSpan(const dxIsland &island)
        : m_island(island), m_span(dxStepEvents::kIsland, island.bodyCount + island.jointCount >= kMinRecorded) {
        if (m_span.ring() != nullptr) m_rowsBefore = m_span.ring()->rows();
    }
    ~dxIslandSpan() {
        if (m_span.ring() == nullptr) return;
        m_span.set(0, m_island.bodyCount);
        m_span.set(1, m_island.jointCount);
        m_span.set(2, m_span.ring()->rows() - m_rowsBefore);
    }

private:
    const dxIsland &m_island;
    dxTimelineSpan m_span;
    std::uint64_t m_rowsBefore = 0;
};

// The solver's part of an island; the rows of all islands are counted.
class dxSolverSpan {
public:
    static constexpr unsigned kMinRecorded = 32;  // rows

    explicit dxSolverSpan(unsigned rows) : m_ring(dxTimeline::ofThisThread()), m_rows(rows) {
        if (m_ring == nullptr) return;
        m_ring->countRows(rows);
        if (rows >= kMinRecorded) m_begin = dxTimelineClock::ticks();
    }
    ~dxSolverSpan() {
        if (m_begin != 0) m_ring->add(dxStepEvents::kSolver, m_begin, dxTimelineClock::ticks(), {m_rows});
    }
    dxSolverSpan(const dxSolverSpan &) = delete;
    dxSolverSpan &operator=(const dxSolverSpan &) = delete;

private:
    dxTimelineRing *const m_ring;
    const unsigned m_rows;
    std::uint64_t m_begin = 0;  // 0: is not recorded
};
