// Solves the constraints of a group of islands approximately, in sweeps from the last step's forces: docs/iterative-solver.md.
//
// Threading: one group, one thread and the group's workers. Memory is kept from group to group; a world keeps as many solvers as
// groups of it are solved at the same time (dxIterativeWorld).
#pragma once

#include <atomic>
#include <vector>

#include "dynamics/quick_step/fast/dxColoredSweeps.h"
#include "dynamics/quick_step/fast/dxConstraintPlan.h"
#include "dynamics/quick_step/fast/dxContactReader.h"
#include "dynamics/quick_step/fast/dxContactSweep.h"
#include "dynamics/quick_step/fast/dxOtherRows.h"
#include "dynamics/step/islands/dxBodyMotion.h"
#include "dynamics/step/islands/dxIslandStep.h"

class dxIterativeSolver {
public:
    // Makes all the plans and takes all memory that solve() needs. Workers find the bodies' free motion meanwhile. Requires tags.
    // Throws std::bad_alloc; nothing of the bodies has changed then.
    void begin(const dxIslandStep &step, dxIslandBody *masses);

    // Writes velocities, feedback, and the forces that the next step begins with.
    void solve(const dxIslandStep &step, dxIslandBody *masses, const dxOtherJoints &joints, dxQuietMotion &motion);

    // Takes as much memory as another solver has. Throws std::bad_alloc.
    void reserveAs(const dxIterativeSolver &other);

    const dxConstraintPlan &plan() const { return m_plan; }

private:
    // Calls work(chunk, its number) for all chunks of the plan, in any order. Parallel.
    template <class Work>
    void forChunks(const dxIslandStep &step, const Work &work) {
        const std::vector<dxConstraintPlan::Chunk> &chunks = m_plan.chunks();
        step.runner().forBlocks(dxParallelStage::Rows, static_cast<unsigned>(chunks.size()),
                                [&](unsigned i, unsigned) { work(chunks[i], i); });
    }

    void makePlan(const dxIslandStep &step);
    void placeLanes();
    void prepare(const dxIslandStep &step, const dxIslandBody *bodies, const dxOtherJoints &joints);
    void sweep(const dxIslandStep &step, dxIslandBody *bodies);
    double solveChunk(unsigned chunk, unsigned round);
    struct Round {
        unsigned sweep;
        dxSweepPart part;
    };
    Round sweepOf(unsigned round) const;
    dxOverRelaxation factorOf(const Round &round) const;
    bool isMeasured(unsigned sweep) const;
    void sumByIsland(std::vector<double> &energies) const;
    void startColdWhereWorse(const dxIslandStep &step, dxIslandBody *bodies, double energy);
    void watchGrowth(double energy, bool isSmoothing);
    bool isSmallEverywhere(double tolerance);
    void writeVelocities(const dxIslandStep &step, dxQuietMotion &motion);

    dxContactPacks packs() {
        return {m_plan.packs().data(), m_contacts.data(), m_packEnergies.data(), m_hasResponses ? m_responses.data() : nullptr};
    }

    dxConstraintPlan m_plan;
    dxColoredSweeps m_sweeps;
    dxOtherRows m_others;
    std::vector<dxContactLanes> m_contacts;
    std::vector<dxContactResponse> m_responses;               // by contact, where there are not too many
    std::vector<const dxConstraintPlan::Manifold *> m_lanes;  // by pack and lane
    std::vector<dxVelocity> m_velocities;                     // by body, and one of a body at rest
    std::vector<dxLaneNumbers> m_packEnergies;                // what the last sweep found
    std::vector<double> m_chunkEnergies;
    std::vector<double> m_firstEnergies, m_islandEnergies;  // by island: of the residual without impulses; of the last sweep
    bool m_hasResponses = false;
    std::atomic<bool> m_hasFeedback{false};  // of contacts that are lanes
    dxOverRelaxation m_factor = {1, 1};
    unsigned m_wholeSweeps = 0;  // that are one round each
    unsigned m_leastSweeps = 0;  // in any case
    unsigned m_smoothFrom = 0;  // the sweep after which none is over-relaxed
    double m_firstEnergy = 0, m_leastEnergy = 0;
};
