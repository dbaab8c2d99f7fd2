// Points at which threads synchronise: claims of work, hand-overs, waits, and commits of results; and a perturbed schedule there, so that tests cover
// rare orders of events.
//
// Every thread calls dxPerturb() at each point. It does nothing unless a perturbation is set: by the environment variable ODE_MT_PERTURB=seed
// (pseudo-random yields and sleeps up to 50 us), or by a test. Results must not change.
//
// Each point is named, so that a test can show that a perturbed schedule has reached it. A new claim, hand-over, wait or commit gets a name here, a
// sentence in dxSchedulePoints.cpp, and a scene in tests/frame/schedule_points_test.cpp, which fails while a point is not reached.
//
// Threading: any thread.
#pragma once

#include <atomic>
#include <cstdint>

enum class dxSchedulePoint : unsigned {
    // Runs of a thread manager
    ClaimSlot,
    OpenRun,
    ClaimSeat,
    ClaimBlock,
    ClaimTeamBlock,
    RunAlone,
    FinishBlocks,
    AwaitBlocks,
    CloseRun,
    // Idle workers
    WakeWorkers,
    Park,
    Unpark,
    ClaimWakeUp,
    // Blocks that are finished one after the other
    FinishInOrder,
    AwaitInOrder,
    // Large islands of QuickStep
    ClaimPartition,
    AnnounceRows,
    AwaitRows,
    // Phases of the fast solvers
    PublishPhase,
    ClaimPhaseChunk,
    AwaitPhaseChunks,
    AwaitPublishedPhase,
    // Islands side by side
    StepIsland,
    InterruptIsland,
    CommitIslands,
    // Random numbers of a step
    ReserveDraws,
    AwaitSingleStepper,
    // Spaces
    ClaimCleaning,
    AwaitCleaning,
    // Contacts computed before their callbacks
    ComputeContacts,
    AnswerCollide,
    // Callbacks that may run at once
    DeliverPair,
    CommitContacts,

    Count
};

constexpr unsigned kSchedulePoints = static_cast<unsigned>(dxSchedulePoint::Count);

// Returns what a thread is about to do there.
const char *dxDescribe(dxSchedulePoint point);

using dxPerturbation = void (*)();

extern std::atomic<dxPerturbation> dxPerturbationInForce;

// Counts the point and calls the perturbation.
void dxPerturbBy(dxPerturbation perturb, dxSchedulePoint point);

inline void dxPerturb(dxSchedulePoint point) {
    const dxPerturbation perturb = dxPerturbationInForce.load(std::memory_order_relaxed);
    if (__builtin_expect(perturb != nullptr, 0)) dxPerturbBy(perturb, point);
}

// Returns how many times threads have been at a point while a perturbation was set.
std::uint64_t dxTimesReached(dxSchedulePoint point);

// Sets the perturbation; null: none.
void dxSetPerturbation(dxPerturbation perturb);

// Sets the pseudo-random perturbation, as ODE_MT_PERTURB=seed does.
void dxSetRandomPerturbation(unsigned seed);
