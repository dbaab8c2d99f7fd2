// Solves the constraints of a group of islands approximately by projected Gauss-Seidel (PGS), from the forces of the last step:
// docs/fast.md. dxPgsSolver.cpp has the stages on one page.
//
// Threading: one group, one thread and the group's workers. Memory is kept from group to group; a world keeps as many solvers as groups of it are
// solved at the same time (dxFastQuickStepState).
#pragma once

#include <atomic>

#include "core/dxStepArena.h"
#include "dynamics/quick_step/fast/dxConstraintPlan.h"
#include "dynamics/quick_step/fast/dxContactReader.h"
#include "dynamics/quick_step/fast/dxContactSweep.h"
#include "dynamics/quick_step/fast/dxJointPack.h"
#include "dynamics/quick_step/fast/dxRowConstraints.h"
#include "dynamics/step/islands/dxBodyMotion.h"
#include "dynamics/step/islands/dxIslandStep.h"
#include "threading/pool/dxPhaseRunner.h"

class dxPgsSolver {
public:
    // Makes the plan and takes all memory that solve() needs, while workers find the bodies' free motion. Requires tags. Throws std::bad_alloc;
    // nothing of the bodies has changed then.
    void begin(const dxIslandStep &step, dxIslandBody *masses);

    // Asks the joints in lanes for their rows. May call the user's message handlers. Returns the number of rows.
    unsigned readJoints(const dxIslandStep &step);

    // Writes velocities, feedback, and the forces with which the next step begins.
    void solve(const dxIslandStep &step, const dxRowJoints &joints, dxNotificationPolicy &notifications);

    const dxConstraintPlan &plan() const { return m_plan; }

    // Provides the memory and the number of threads that another solver has, between groups. Throws std::bad_alloc.
    void reserve(std::size_t memory, unsigned threads);
    std::size_t memory() const { return m_arena.capacity(); }
    unsigned threads() const { return m_phases.capacity(); }

private:
    // The stages of a solution, in their order.
    enum class Stage {
        Prepare,    // joints become lanes and rows
        WarmStart,  // impulses of the last step act on the velocities
        Sweep,      // iterations that are over-relaxed
        Smooth,     // the last iterations, which are not: that leaves smaller residuals
        Sum,        // impulses act on the free velocities once more, in dReal
        Store,      // velocities, feedback, forces for the next step
    };

    struct Call {
        const dxIslandStep &step;
        const dxRowJoints &joints;
        dxNotificationPolicy &notifications;
    };

    void makePlan(const dxIslandStep &step);
    void run(Stage stage, const Call &call);
    void prepare(const dxIslandStep &step, const dxRowJoints &joints);
    void startWarm(const dxIslandStep &step);
    void iterate(Stage stage, unsigned begin, unsigned end, double tolerance);
    void endOverRelaxation();
    double sweep(Stage stage, unsigned number);
    double sweepPart(dxSweepPart part, const dxOverRelaxation &factor, unsigned number);
    void sumImpulses();
    void store(const dxIslandStep &step, const dxRowJoints &joints, dxNotificationPolicy &notifications);

    template <class Work>
    void forChunks(const dxIslandStep &step, const Work &work);
    template <class Solve>
    double solvePhases(const Solve &solve);
    dxOverRelaxation factorOf(Stage stage, dxSweepPart part) const;
    bool isMeasured(unsigned sweep) const;
    void sumByIsland(dxArenaArray<double> energies) const;
    void startColdWhereWorse(const dxIslandStep &step, double energy);
    void watchGrowth(Stage stage, double energy);
    bool isSmallEverywhere(double tolerance) const;

    dxContactPacks packs() const {
        return {m_plan.packs().data(), m_contacts.data(), m_packEnergies.data(), m_responses.data()};
    }
    dxJointPacks jointPacks() const { return {m_plan.jointPacks().data(), m_jointLanes.data(), m_jointPackEnergies.data()}; }

    dxStepArena m_arena;  // of all arrays
    dxConstraintPlan m_plan;
    dxRowConstraints m_rows;
    dxPhaseRunner m_phases;
    dxIslandBody *m_masses = nullptr;  // of the step's arena
    dxArenaArray<dxContactLanes> m_contacts;
    dxArenaArray<dxContactResponse> m_responses;                // by contact; none where there are too many
    dxArenaArray<const dxConstraintPlan::Manifold *> m_lanes;   // by pack and lane; null: none
    dxArenaArray<dxSpatialMotion> m_velocities;                 // by body, and one of a body at rest
    dxArenaArray<dxSpatialMotion> m_results;                    // by body: m_velocities; with lanes, the free velocities until Sum
    dxArenaArray<dxLaneNumbers> m_packEnergies;                 // found last
    dxArenaArray<double> m_chunkEnergies;                       // found last
    dxArenaArray<double> m_firstEnergies, m_islandEnergies;     // by island: of the residual without impulses; found last
    dxArenaArray<dxJointLanes> m_jointLanes;
    dxArenaArray<dxLaneNumbers> m_jointPackEnergies;            // found last
    std::atomic<bool> m_hasFeedback{false};                     // of contacts in lanes
    dxOverRelaxation m_factor = {1, 1};
    unsigned m_iterations = 0;         // the largest number of sweeps
    unsigned m_minSweeps = 0;          // that are made in any case
    unsigned m_allRowsSweeps = 0;      // that have one part, at first
    unsigned m_firstSmoothSweep = 0;
    bool m_isConverged = false;        // no more sweeps are needed
    double m_firstEnergy = 0, m_leastEnergy = 0;
};
