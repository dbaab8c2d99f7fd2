// What dODE_MT_GetWorldStatistics tells of the last frame of a world: counts and times that agree with one another, the world to which a
// collision belongs, and each reason for one thread that a program can bring about.
#include <fenv.h>
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <cstddef>
#include <cstring>
#include <functional>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "ChainWorld.h"
#include "support/child_run.h"
#include "HeapWorld.h"
#include "OdeSession.h"
#include "SphereRows.h"
#include "last_message.h"
#include "settings/dxSettings.h"

namespace {

dODE_MT_WorldStatistics statisticsOf(dWorldID world) {
    dODE_MT_WorldStatistics statistics{};
    statistics.size = sizeof statistics;
    EXPECT_EQ(dODE_MT_GetWorldStatistics(world, &statistics), 1);
    EXPECT_EQ(statistics.size, sizeof statistics);
    return statistics;
}

// Without asking for anything.
void startRecording() {
    const dWorldID world = dWorldCreate();
    dODE_MT_WorldStatistics statistics{};
    statistics.size = sizeof statistics;
    EXPECT_EQ(dODE_MT_GetWorldStatistics(world, &statistics), 0);
    EXPECT_EQ(statistics.frames, 0u);
    dWorldDestroy(world);
}

void play(HeapWorld &heap, int frames) {
    for (int i = 0; i < frames; ++i) {
        heap.collide();
        heap.step();
    }
}

void makeNothing(void *, dGeomID, dGeomID) {}

class WorldStatistics : public testing::Test {
protected:
    WorldStatistics() { startRecording(); }
    ~WorldStatistics() override { dODE_MT_SetCallbackPolicy("serial"); }

    // A step of separate chains, and its reason.
    int stepReason(unsigned chains, unsigned links, const std::function<void(dWorldID)> &prepare = nullptr,
                   dWorldStepFunction *stepper = dWorldQuickStep) {
        ChainWorld world(chains, links, stepper);
        if (prepare) prepare(world.world());
        world.step();
        return statisticsOf(world.world()).stepReason;
    }

    const OdeSession session{0, "auto"};
};

TEST_F(WorldStatistics, CountsAndTimesOfAFrameAgree) {
    HeapWorld heap(dHashSpaceCreate(nullptr));
    play(heap, 1);
    const dODE_MT_WorldStatistics first = statisticsOf(heap.world());
    EXPECT_EQ(first.frames, 1u);
    EXPECT_EQ(first.frameTime, 0);
    play(heap, 24);
    const dODE_MT_WorldStatistics last = statisticsOf(heap.world());
    EXPECT_EQ(last.number, first.number);
    EXPECT_EQ(last.frames, 25u);
    EXPECT_EQ(last.bodies, 2u * HeapWorld::kSide * HeapWorld::kSide);
    EXPECT_GT(last.contacts, 0u);
    EXPECT_GT(last.islands, 0u);
    EXPECT_EQ(last.rows, 3u * last.contacts);
    EXPECT_GT(last.pairs, 0u);
    EXPECT_EQ(last.collisions, 1u);
    EXPECT_EQ(last.allCollisions, 25u);
    EXPECT_EQ(last.collisionThreads, 1u);
    EXPECT_EQ(last.stepThreads, 1u);
    EXPECT_EQ(last.parallelSteps, 0u);

    EXPECT_GT(last.broadPhaseTime, 0);
    EXPECT_GT(last.callbackTime, 0);
    EXPECT_GT(last.islandSearchTime, 0);
    EXPECT_GT(last.islandsTime, 0);
    EXPECT_LE(last.broadPhaseTime + last.callbackTime, 1.001 * last.collisionTime);
    EXPECT_LE(last.islandSearchTime + last.islandsTime, 1.001 * last.stepTime);
    EXPECT_LE(last.collisionTime + last.stepTime, 1.001 * last.frameTime);
    EXPECT_GT(last.allStepTime, last.stepTime);
    EXPECT_LT(last.frameTime, 60) << "seconds";
    EXPECT_EQ(last.sharedTime, 0);
    EXPECT_EQ(last.workTime, 0);
    EXPECT_EQ(last.serialShare, 1);
}

// The calling thread's time outside of shared stages, and the work of two threads in them.
TEST_F(WorldStatistics, TheSerialShareBoundsTheGain) {
    OdeSession::use(2, "lcp");
    HeapWorld heap(dHashSpaceCreate(nullptr));
    dODE_MT_WorldStatistics frame{};
    for (int i = 0; i < 200 && (frame.stepThreads < 2 || frame.collisionThreads < 2); ++i) {
        play(heap, 1);
        frame = statisticsOf(heap.world());
    }
    ASSERT_EQ(frame.stepThreads, 2u);
    ASSERT_EQ(frame.collisionThreads, 2u);
    EXPECT_GT(frame.sharedTime, 0);
    EXPECT_LT(frame.sharedTime, frame.collisionTime + frame.stepTime);
    EXPECT_GT(frame.workTime, 0);
    EXPECT_LE(frame.workTime, 2.001 * frame.sharedTime);
    const double alone = frame.collisionTime + frame.stepTime - frame.sharedTime;
    EXPECT_DOUBLE_EQ(frame.serialShare, alone / (alone + frame.workTime));
}

// One more than the library knows, as from a later header, and one of the first version's beginning.
TEST_F(WorldStatistics, TheSizeSaysHowMuchIsWritten) {
    ChainWorld chains(2, 2);
    chains.step();
    struct Later {
        dODE_MT_WorldStatistics known;
        unsigned more = 7;
    } later{};
    later.known.size = sizeof later;
    EXPECT_EQ(dODE_MT_GetWorldStatistics(chains.world(), &later.known), 1);
    EXPECT_EQ(later.known.size, sizeof later.known);
    EXPECT_EQ(later.more, 7u);

    dODE_MT_WorldStatistics small;
    std::memset(&small, 0xaa, sizeof small);
    const dODE_MT_WorldStatistics untouched = small;
    const std::size_t size = offsetof(dODE_MT_WorldStatistics, contacts);
    small.size = size;
    EXPECT_EQ(dODE_MT_GetWorldStatistics(chains.world(), &small), 1);
    EXPECT_EQ(small.size, size);
    EXPECT_EQ(small.bodies, 4u);
    EXPECT_EQ(std::memcmp(reinterpret_cast<char *>(&small) + size, reinterpret_cast<const char *>(&untouched) + size, sizeof small - size), 0);

    dSetMessageHandler(keepLastMessage);
    small.size = sizeof small.size;
    EXPECT_EQ(dODE_MT_GetWorldStatistics(chains.world(), &small), 0);
    dSetMessageHandler(nullptr);
    EXPECT_EQ(lastMessage, "ODE_MT: dODE_MT_GetWorldStatistics was given a size of 8 bytes, which is too small");
}

TEST_F(WorldStatistics, WorldsHaveTheirOwn) {
    ChainWorld one(3, 2), other(5, 4);
    one.step(2);
    other.step(3);
    EXPECT_EQ(statisticsOf(one.world()).frames, 2u);
    EXPECT_EQ(statisticsOf(one.world()).bodies, 6u);
    EXPECT_EQ(statisticsOf(other.world()).frames, 3u);
    EXPECT_EQ(statisticsOf(other.world()).islands, 5u);
    EXPECT_EQ(statisticsOf(one.world()).collisions, 0u);
    EXPECT_EQ(statisticsOf(one.world()).collisionReason, dODE_MT_REASON_NOTHING);
}

TEST_F(WorldStatistics, ACollisionBelongsToTheWorldOfItsBodiesUntilThatIsStepped) {
    SphereRows rows(dHashSpaceCreate(nullptr));
    ChainWorld other(1, 2);
    std::thread([&rows] {
        dAllocateODEDataForThread(dAllocateMaskAll);
        dSpaceCollide(rows.space(), nullptr, makeNothing);
        dCleanupODEAllDataForThread();
    }).join();
    dSpaceCollide(rows.space(), nullptr, makeNothing);
    other.step();
    EXPECT_EQ(statisticsOf(other.world()).collisions, 0u);
    dWorldStep(rows.world(), dReal(0.01));
    const dODE_MT_WorldStatistics frame = statisticsOf(rows.world());
    EXPECT_EQ(frame.collisions, 2u);
    EXPECT_EQ(frame.pairs, 2u * SphereRows::kPairs);
    EXPECT_GT(frame.collisionTime, 0);
    dWorldStep(rows.world(), dReal(0.01));
    EXPECT_EQ(statisticsOf(rows.world()).collisions, 0u);
    EXPECT_EQ(statisticsOf(rows.world()).collisionTime, 0);
}

void collideNested(void *data, dGeomID geom1, dGeomID geom2) {
    for (const dGeomID geom : {geom1, geom2})
        if (dGeomIsSpace(geom)) dSpaceCollide(reinterpret_cast<dSpaceID>(geom), data, makeNothing);
}

// Their times are those of the callbacks around them, their pairs are counted.
TEST_F(WorldStatistics, CollisionsInCallbacksAreAPartOfTheOneAroundThem) {
    const dSpaceID outer = dSimpleSpaceCreate(nullptr), inner = dSimpleSpaceCreate(outer);
    dCreateBox(outer, 100, 100, 100);
    const dWorldID world = dWorldCreate();
    for (int i = 0; i < 2; ++i) dGeomSetBody(dCreateSphere(inner, 1), dBodyCreate(world));
    dSpaceCollide(outer, nullptr, collideNested);
    dWorldStep(world, dReal(0.01));
    const dODE_MT_WorldStatistics frame = statisticsOf(world);
    EXPECT_EQ(frame.collisions, 1u);
    EXPECT_EQ(frame.pairs, 2u);
    EXPECT_LE(frame.broadPhaseTime + frame.callbackTime, 1.001 * frame.collisionTime);
    dSpaceDestroy(outer);
    dWorldDestroy(world);
}

// A near-callback collides two balls of another space, which may take no part of what is known of the collision around it.
void collideTwoBalls(HeapWorld &heap, dGeomID geom1, dGeomID geom2) {
    static const dSpaceID balls = [] {
        const dSpaceID space = dSimpleSpaceCreate(nullptr);
        for (int i = 0; i < 2; ++i) dCreateSphere(space, 1);
        return space;
    }();
    dSpaceCollide(balls, nullptr, makeNothing);
    heap.makeContacts(geom1, geom2);
}

TEST_F(WorldStatistics, CollisionsInCallbacksLeaveTheThreadsOfTheOneAroundThem) {
    OdeSession::use(2, "lcp");
    HeapWorld heap(dHashSpaceCreate(nullptr));
    heap.setCallback(collideTwoBalls);
    dODE_MT_WorldStatistics frame{};
    for (int i = 0; i < 200 && frame.collisionThreads < 2; ++i) {
        play(heap, 1);
        frame = statisticsOf(heap.world());
    }
    EXPECT_EQ(frame.collisionThreads, 2u);
}

ChainWorld *steppedInCallbacks = nullptr;

TEST_F(WorldStatistics, AStepInACallbackOfAStepIsAFrameOfItsOwn) {
    ChainWorld outer(20, 4), inner(3, 2);
    steppedInCallbacks = &inner;
    dBodySetMovedCallback(dBodyCreate(outer.world()), [](dBodyID) { steppedInCallbacks->step(2); });
    outer.step(5);
    const dODE_MT_WorldStatistics frame = statisticsOf(outer.world()), within = statisticsOf(inner.world());
    EXPECT_EQ(frame.frames, 5u);
    EXPECT_EQ(frame.bodies, 81u);
    EXPECT_EQ(within.frames, 10u);
    EXPECT_EQ(within.bodies, 6u);
    ChainWorld alone(20, 4);
    alone.step(5);
    EXPECT_EQ(frame.rows, statisticsOf(alone.world()).rows);
    EXPECT_GT(frame.islandSearchTime, 0);
    EXPECT_GE(frame.stepTime, within.stepTime);
    EXPECT_LE(frame.islandSearchTime + frame.islandsTime, 1.001 * frame.stepTime);
}

TEST_F(WorldStatistics, AStepInANearCallbackLeavesTheCollisionAroundIt) {
    for (const char *policy : {"serial", "concurrent"}) {
        OdeSession::use(policy[0] == 's' ? 0 : 2, "lcp");
        dODE_MT_SetCallbackPolicy(policy);
        SphereRows rows(dHashSpaceCreate(nullptr));
        ChainWorld inner(3, 2);
        const auto stepOnce = [](void *data, dGeomID, dGeomID) {
            static std::mutex mutex;
            const std::lock_guard<std::mutex> hold(mutex);
            static_cast<ChainWorld *>(data)->step();
        };
        dSpaceCollide(rows.space(), &inner, stepOnce);
        dWorldStep(rows.world(), dReal(0.01));
        const dODE_MT_WorldStatistics frame = statisticsOf(rows.world());
        EXPECT_EQ(statisticsOf(inner.world()).frames, static_cast<unsigned>(SphereRows::kPairs)) << policy;
        EXPECT_EQ(frame.frames, 1u) << policy;
        EXPECT_EQ(frame.collisions, 1u) << policy;
        EXPECT_EQ(frame.pairs, static_cast<unsigned>(SphereRows::kPairs)) << policy;
        EXPECT_GT(frame.broadPhaseTime, 0) << policy;
        EXPECT_GT(frame.callbackTime, 0) << policy;
        EXPECT_LE(frame.broadPhaseTime + frame.callbackTime, 1.001 * frame.collisionTime) << policy;
    }
}

TEST_F(WorldStatistics, ThreadsAndThePrefetchAreCounted) {
    OdeSession::use(2, "lcp");
    HeapWorld heap(dHashSpaceCreate(nullptr));
    dODE_MT_WorldStatistics frame{};
    for (int i = 0; i < 200 && (frame.parallelSteps < 2 || frame.parallelCollisions < 2 || frame.contactsAhead == 0); ++i) {
        play(heap, 1);
        frame = statisticsOf(heap.world());
    }
    EXPECT_GE(frame.parallelSteps, 2u);
    EXPECT_GE(frame.parallelCollisions, 2u);
    EXPECT_EQ(frame.threads, 2u);
    ASSERT_GT(frame.contactsAhead, 0u);
    EXPECT_LE(frame.contactsAhead, frame.pairs);
    EXPECT_DOUBLE_EQ(frame.hitRate, static_cast<double>(frame.contactsAhead - frame.contactsAheadUnused) / static_cast<double>(frame.contactsAhead));
    EXPECT_GT(frame.prefetchTime, 0);
    EXPECT_LE(frame.prefetchTime, frame.callbackTime);
    EXPECT_EQ(frame.callbackReason, dODE_MT_REASON_CALLBACK_POLICY);
}

// Its own, or else the process's. Both are read after the step.
TEST_F(WorldStatistics, ThreadsAreThoseInForceForTheWorld) {
    OdeSession::use(2, "lcp");
    ChainWorld own(4, 2), other(4, 2);
    const auto threadsOf = [](ChainWorld &chains) {
        chains.step();
        return statisticsOf(chains.world()).threads;
    };
    ASSERT_EQ(dODE_MT_SetWorldThreads(own.world(), 3), 1);
    EXPECT_EQ(threadsOf(own), 3u);
    EXPECT_EQ(threadsOf(other), 2u);
    ASSERT_EQ(dODE_MT_SetWorldThreads(own.world(), 1), 1);
    EXPECT_EQ(threadsOf(own), 1u);
    ASSERT_EQ(dODE_MT_SetWorldThreads(own.world(), 0), 1);
    EXPECT_EQ(threadsOf(own), 2u);
    dToggleODE_MT(0);
    EXPECT_EQ(threadsOf(own), 0u);
    ASSERT_EQ(dODE_MT_SetWorldThreads(own.world(), dODE_MT_AUTO), 1);
    EXPECT_EQ(threadsOf(own), static_cast<unsigned>(dODE_MT_GetWorldThreads(own.world())));
}

TEST_F(WorldStatistics, ReasonsOfTheStep) {
    EXPECT_EQ(stepReason(20, 3), dODE_MT_REASON_THREADS);
    OdeSession::use(2, "serial");
    EXPECT_EQ(stepReason(20, 3), dODE_MT_REASON_ALGORITHM);
    OdeSession::use(2, "lcp");
    EXPECT_EQ(stepReason(0, 0), dODE_MT_REASON_NOTHING);
    EXPECT_EQ(stepReason(1, 3), dODE_MT_REASON_SMALL_ISLAND);
    EXPECT_EQ(stepReason(20, 3, [](dWorldID world) { dWorldSetStepIslandsProcessingMaxThreadCount(world, 1); }), dODE_MT_REASON_WORLD_LIMIT);
    EXPECT_EQ(stepReason(2, 1, [](dWorldID world) { dWorldSetQuickStepNumIterations(world, 100001); }), dODE_MT_REASON_ITERATIONS);
    const int withCallbacks = stepReason(20, 3, [](dWorldID world) {
        for (int i = 0; i < 2; ++i) dBodySetMovedCallback(dBodyCreate(world), [](dBodyID) {});
    });
    EXPECT_EQ(withCallbacks, dODE_MT_REASON_MOVED_CALLBACK);
    dJointFeedback feedback{};
    const int withOneFeedback = stepReason(0, 0, [&feedback](dWorldID world) {
        for (int i = 0; i < 2; ++i) {
            const dJointID joint = dJointCreateBall(world, nullptr);
            dJointAttach(joint, dBodyCreate(world), nullptr);
            dJointSetFeedback(joint, &feedback);
        }
    });
    EXPECT_EQ(withOneFeedback, dODE_MT_REASON_FEEDBACK);
    OdeSession::use(2, "auto");
    if (dxSettings::instance().cores() < 2) {
        EXPECT_EQ(stepReason(20, 3), dODE_MT_REASON_CORES);
    } else {
        const int cheap = stepReason(2, 1);
        EXPECT_TRUE(cheap == dODE_MT_REASON_COST || cheap == dODE_MT_REASON_PARALLEL || cheap == dODE_MT_REASON_LATE_WORKERS)
            << dODE_MT_GetReasonText(cheap);
    }
}

TEST_F(WorldStatistics, TrappedFloatingPointErrorsAreAReason) {
    OdeSession::use(2, "lcp");
    feenableexcept(FE_DIVBYZERO);
    const int step = stepReason(20, 3);
    fedisableexcept(FE_DIVBYZERO);
    EXPECT_EQ(step, dODE_MT_REASON_FLOAT_TRAPS);
}

TEST_F(WorldStatistics, ReasonsOfTheCollision) {
    const auto reasons = [](HeapWorld &heap) {
        play(heap, 1);
        const dODE_MT_WorldStatistics frame = statisticsOf(heap.world());
        return std::make_pair(frame.collisionReason, frame.callbackReason);
    };
    HeapWorld heap(dHashSpaceCreate(nullptr));
    EXPECT_EQ(reasons(heap).first, dODE_MT_REASON_THREADS);
    OdeSession::use(2, "serial");
    EXPECT_EQ(reasons(heap).second, dODE_MT_REASON_ALGORITHM);
    OdeSession::use(2, "auto");
    const dWorldID world = dWorldCreate();
    const dSpaceID few = dSimpleSpaceCreate(nullptr);
    for (int i = 0; i < 2; ++i) dGeomSetBody(dCreateSphere(few, 1), dBodyCreate(world));
    dSpaceCollide(few, nullptr, makeNothing);
    dWorldStep(world, dReal(0.01));
    if (dxSettings::instance().cores() >= 2) {
        EXPECT_EQ(statisticsOf(world).collisionReason, dODE_MT_REASON_FEW_GEOMS);
        EXPECT_EQ(statisticsOf(world).pairs, 1u);
    }
    dSpaceDestroy(few);
    dWorldDestroy(world);
}

TEST_F(WorldStatistics, EachReasonHasATextOfItsOwn) {
    std::set<std::string> texts;
    for (int reason = 0; reason <= dODE_MT_REASON_WORLDS; ++reason) texts.insert(dODE_MT_GetReasonText(reason));
    EXPECT_EQ(texts.size(), dODE_MT_REASON_WORLDS + 1u);
    EXPECT_EQ(texts.count("unknown reason"), 0u);
    for (const int reason : {-1, dODE_MT_REASON_WORLDS + 1, 0x7fffffff}) EXPECT_STREQ(dODE_MT_GetReasonText(reason), "unknown reason");
}

TEST_F(WorldStatistics, ANewWorldInTheSamePlaceBeginsAnew) {
    unsigned last = 0;
    for (int i = 0; i < 3; ++i) {
        ChainWorld chains(1, 1);
        chains.step();
        const dODE_MT_WorldStatistics frame = statisticsOf(chains.world());
        EXPECT_EQ(frame.frames, 1u);
        EXPECT_GT(frame.number, last);
        last = frame.number;
    }
}

TEST_F(WorldStatistics, GoOnInAForkedChild) {
    ChainWorld chains(20, 4);
    chains.step(2);
    EXPECT_TRUE(support::trueInChild([&chains] {
        chains.step(2);
        return statisticsOf(chains.world()).frames == 4;
    }));
    EXPECT_EQ(statisticsOf(chains.world()).frames, 2u);
}

// In a process that has recorded nothing yet.
TEST(WorldStatisticsOnAndOff, ChangeNoBit) {
    const auto positions = [] {
        dRandSetSeed(7);
        HeapWorld heap(dHashSpaceCreate(nullptr));
        play(heap, 20);
        return heap.positions();
    };
    const OdeSession session(2, "lcp");
    const std::vector<dReal> before = positions();
    startRecording();
    EXPECT_EQ(positions(), before);
}

}  // namespace
