// The parallel stages of a step and of a collision, and whether at least two workers have run each.
//
// A stage that always runs on one worker is untested for races. So every parallel run names its stage (dxTaskRunner),
// and a test runs scenes until two workers have run each one (parallel_stages_test).
//
// Threading: relaxed atomics, written by workers, read by any thread. A run on the calling thread alone writes nothing.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>

#include "core/dxNoIndex.h"

enum class dxParallelStage : unsigned char {
    WorldSurvey,          // code of the user's in each of many worlds: dxWorldRuns
    WorldPreparation,     // their islands: dxStepWorlds
    Worlds,               // worlds side by side
    IslandSurvey,         // what a step looks at in each island first: dxStep
    Islands,              // islands side by side
    Boxes,                // bounding boxes of a space that is made ready: dxOrderedSpace
    CellGridPairs,        // pairs in rows of cells: dxGridBroadphase
    VerletChanges,        // members that have moved: dxVerletBroadphase
    VerletCandidates,     // pairs of its list that are compared
    PairKeys,             // places of found pairs in upstream's order: dxKeptPairs
    KeptPairKeys,         // the same of all pairs that are kept
    NarrowphasePrefetch,  // contacts before their callbacks: dxNarrowphasePrefetch
    Callbacks,            // near-callbacks that may run at once: dxConcurrentCallbacks
    Bodies,               // QuickStep: inertia and gravity: dxIslandBodies
    Joints,               // QuickStep: Jacobians and limits
    RightHandSides,       // QuickStep
    Rows,                 // QuickStep: rows prepared for the sweep: dxSorSolver
    SorPlan,              // QuickStep: order of rows for each worker: dxParallelSor
    SorSweep,             // QuickStep: the sweep
    PgsSweep,             // fast QuickStep: warm start and sweeps: dxPgsSolver
    Motion,               // QuickStep: velocities and positions: dxBodyMotion
    BodySpace,            // fast dWorldStep: phases in body space: dxBodySpaceSolver
    Fronts,               // fast dWorldStep: bilateral rows alone: dxBilateralSystem
    PanelSolve,           // exact step: solves of several right-hand sides: dxPanelSolve
    TransposedSolve,      // exact step: back substitution: dxSolveL1Transposed
    SparseProducts,       // exact step: products with rows in C: dxSparseRows
    Count,                // of stages, itself none
};

class dxParallelStages {
public:
    static constexpr std::size_t kCount = static_cast<std::size_t>(dxParallelStage::Count);

    // In the order of the enumeration.
    static constexpr std::array<const char *, kCount> kNames = {
        "world survey", "world preparation", "worlds", "island survey", "islands", "boxes", "cell-grid pairs", "Verlet changes",
        "Verlet candidates", "pair keys", "kept pair keys", "narrow-phase prefetch", "callbacks", "bodies", "joints", "right-hand sides",
        "rows", "SOR plan", "SOR sweep", "PGS sweep", "motion", "body space", "fronts", "panel solve", "transposed solve", "sparse products"};

    static bool ranByTwo(dxParallelStage stage) { return flag(stage).load(std::memory_order_relaxed); }
    static void noteTwo(dxParallelStage stage) { flag(stage).store(true, std::memory_order_relaxed); }

private:
    static std::atomic<bool> &flag(dxParallelStage stage) {
        static std::array<std::atomic<bool>, kCount + 1> flags{};  // the last: no stage, for tests
        return flags[static_cast<std::size_t>(stage)];
    }
};

// Watches the workers of one run until two have run its stage. From then on a block costs one comparison.
//
// Dropped: the number of workers of every run. With many workers their first blocks would wait for one counter.
class dxStageWatch {
public:
    explicit dxStageWatch(dxParallelStage stage) : m_stage(stage), m_isKnown(dxParallelStages::ranByTwo(stage)) {}

    // Called when a worker has run a block.
    void see(unsigned worker) {
        if (m_isKnown) return;
        unsigned first = kNoIndex;
        if (!m_first.compare_exchange_strong(first, worker, std::memory_order_relaxed) && first != worker)
            dxParallelStages::noteTwo(m_stage);
    }

private:
    const dxParallelStage m_stage;
    const bool m_isKnown;
    std::atomic<unsigned> m_first{kNoIndex};
};
