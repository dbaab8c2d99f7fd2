// Points at which threads synchronise: claims of work, hand-overs, waits, and commits of results.
//
// Each is named, so that a disturbed schedule (dxPerturbation) can be shown to have reached it. A new claim, hand-over, wait
// or commit gets a name here, a sentence in dxSchedulePoint.cpp, and a scene in tests/frame/schedule_points_test.cpp, which fails while
// a point is not reached.
#pragma once

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

// What a thread is about to do there.
const char *dxDescribe(dxSchedulePoint point);
