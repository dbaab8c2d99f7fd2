// One step of one world: the islands that upstream's search found are stepped in order on the calling
// thread, or shared out to workers, or one large island to all workers; with the same bits.
//
// Source: thesis chapter 11 (island-parallel LCP). Upstream's dxProcessIslands, which this replaces, lets
// threads take islands as they come: its random numbers, list orders and messages then differ from run
// to run. See docs/frame.md for the picture and docs/same-bits.md for why the bits stay the same.
#pragma once

#include <atomic>

#include "dynamics/dxIsland.h"
#include "dynamics/dxIslandTeam.h"
#include "frame/dxCostModel.h"
#include "frame/dxStepRecords.h"
#include "threading/dxThreadManager.h"

class dxStep {
public:
    dxStep(dxWorld *world, const dxWorldProcessIslandsInfo &info, dReal stepSize, dstepper_fn_t stepper);

    void run();

private:
    // --- in order: upstream's frame -------------------------------------------------------------------
    void runInOrder();
    void runInOrderReserving();  // with a block of random numbers taken in advance
    void stepInOrder(dxIslandCursor cursor, unsigned count);
    void stepIsland(const dxIsland &island, dxWorldProcessMemArena *arena);

    // --- with a team: in order, large islands by several workers together -------------------------------
    void runWithTeam(unsigned workers);
    bool hasTeamIsland(unsigned limit) const;
    bool shallHaveTeam() const;
    void rememberTeam(bool hadTeam, double ns) const;

    // --- shared out: the stages, in this order; those marked run on workers ----------------------------
    void runShared(unsigned workers);
    bool prepareShared(unsigned workers);
    void prepareRecords(unsigned workers);
    void survey(unsigned begin, unsigned end, unsigned worker);  // workers: user callbacks, rows, feedback
    void orderSharedFeedback();
    void reserveRandomNumbers();
    void stepBlock(unsigned block, unsigned worker);  // workers
    void stepLeftovers();
    unsigned commit();
    void finishInOrder(unsigned begin);

    void stepDeferred(unsigned index, unsigned worker);
    void takeBack(unsigned begin);
    void deliverReports(unsigned island) const;
    void interruptAt(unsigned island);
    void learn(unsigned workers, double wallNs) const;

    // --- who may work ----------------------------------------------------------------------------------
    bool mayShare() const;
    bool mayBeEndless() const;
    unsigned leastTeamJoints() const;
    bool isTeamMeasured() const;
    void estimateCosts();
    unsigned chooseWorkers(unsigned limit);
    unsigned workerLimit() const;

    bool drawsRandomNumbers() const;
    std::uint64_t drawsOf(unsigned rows) const;

    dxWorld *const m_world;
    const dxWorldProcessIslandsInfo &m_info;
    const dReal m_stepSize;
    const dxStepperKind m_kind;
    const unsigned m_count;     // islands
    const bool m_userHandlers;  // an error, debug or message handler is installed

    dxIslandTeam *m_team = nullptr;  // of large islands
    dxStepRecords::Lease m_records;
    double m_totalCost = 0;  // of the islands before the first user callback, see dxCostModel
    double m_largestCost = 0;
    unsigned m_largestJoints = 0;
    bool m_costsKnown = false;            // and there is no such callback
    unsigned m_inOrderFrom = 0;           // first island that has to be stepped in order
    std::uint32_t m_randomEnd = 0;        // the random sequence after the reserved block
    std::atomic<unsigned> m_interrupted;  // first island that has to be stepped again in order
};
