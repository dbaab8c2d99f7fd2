// dODE_MT_StepWorlds: the bits of a loop over dWorldStep or dWorldQuickStep, whatever the worlds share and whoever steps them.
//
// Covers api/ode_MT_worlds.cpp, dxWorldRuns.cpp.
#include "dynamics/step/dxStepWorlds.h"

#include <gtest/gtest.h>
#include <ode/ode.h>

#include <chrono>
#include <csignal>
#include <limits>
#include <memory>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "ChainWorld.h"
#include "support/child_run.h"
#include "OdeSession.h"
#include "last_message.h"

namespace {

struct Way {
    int threads;
    const char *algorithm;
};

[[maybe_unused]] void PrintTo(const Way &way, std::ostream *out) { *out << way.threads << " threads, " << way.algorithm; }

// Worlds of different sizes: every fifth one is fast, every seventh one sweeps its rows in another number of iterations.
class Worlds {
public:
    explicit Worlds(dWorldStepFunction *stepper, unsigned count = 40) : m_name(stepper == dWorldStep ? "step" : "quick") {
        dRandSetSeed(11);
        for (unsigned i = 0; i < count; ++i) {
            m_worlds.push_back(std::make_unique<ChainWorld>(1 + i % 4, 2 + i % 3, stepper));
            if (i % 5 == 4) dODE_MT_SetSolver(world(i), "fast");
            if (i % 7 == 6) dWorldSetQuickStepNumIterations(world(i), 5 + static_cast<int>(i));
        }
    }

    dWorldID world(unsigned index) const { return m_worlds[index]->world(); }
    ChainWorld &chains(unsigned index) { return *m_worlds[index]; }
    unsigned count() const { return static_cast<unsigned>(m_worlds.size()); }

    void stepOneByOne() {
        for (const auto &world : m_worlds) world->step();
    }

    int stepTogether(dReal stepSize = REAL(0.01)) {
        std::vector<dWorldID> worlds;
        for (const auto &world : m_worlds) worlds.push_back(world->world());
        return dODE_MT_StepWorlds(worlds.data(), static_cast<int>(worlds.size()), m_name, stepSize);
    }

    // Of all worlds, and of the random sequence.
    std::vector<dReal> state() const {
        std::vector<dReal> all;
        for (const auto &world : m_worlds) {
            const std::vector<dReal> one = world->state();
            all.insert(all.end(), one.begin(), one.end());
        }
        all.push_back(static_cast<dReal>(dRandGetSeed()));
        return all;
    }

    // Numbers of the workers that have stepped a body in the last step.
    std::set<int> workers() const {
        std::set<int> all;
        for (const auto &world : m_worlds)
            for (const dBodyID body : world->bodies()) all.insert(dODE_MT_GetBodyWorker(body));
        return all;
    }

private:
    const char *m_name;
    std::vector<std::unique_ptr<ChainWorld>> m_worlds;
};

constexpr int kSteps = 12;

// `change` is done to the worlds of both before the first step.
template <class Change>
void expectLoop(dWorldStepFunction *stepper, const Change &change) {
    Worlds looped(stepper);
    change(looped);
    for (int i = 0; i < kSteps; ++i) looped.stepOneByOne();
    const std::vector<dReal> expected = looped.state();
    Worlds together(stepper);
    change(together);
    for (int i = 0; i < kSteps; ++i) EXPECT_EQ(together.stepTogether(), 1);
    EXPECT_EQ(together.state(), expected);
}

class StepWorlds : public testing::TestWithParam<Way> {
protected:
    OdeSession session{GetParam().threads, GetParam().algorithm};
};

TEST_P(StepWorlds, GiveTheBitsOfALoop) {
    for (dWorldStepFunction *const stepper : {dWorldStep, dWorldQuickStep}) expectLoop(stepper, [](Worlds &) {});
}

// Its islands are shared out, in its place among the others.
TEST_P(StepWorlds, OneOfWhichIsLarge) {
    for (dWorldStepFunction *const stepper : {dWorldStep, dWorldQuickStep}) {
        std::vector<std::vector<dReal>> states;
        for (const bool isTogether : {false, true}) {
            dRandSetSeed(3);
            ChainWorld first(2, 3, stepper), second(1, 2, stepper), large(60, 5, stepper), last(3, 2, stepper), behind(1, 4, stepper);
            const dWorldID all[] = {first.world(), second.world(), large.world(), last.world(), behind.world()};
            for (int i = 0; i < kSteps; ++i) {
                if (isTogether)
                    EXPECT_EQ(dODE_MT_StepWorlds(all, 5, stepper == dWorldStep ? "step" : "quick", REAL(0.01)), 1);
                else
                    for (ChainWorld *const world : {&first, &second, &large, &last, &behind}) world->step();
            }
            std::vector<dReal> state{static_cast<dReal>(dRandGetSeed())};
            for (const ChainWorld *const world : {&first, &second, &large, &last, &behind}) {
                const std::vector<dReal> one = world->state();
                state.insert(state.end(), one.begin(), one.end());
            }
            states.push_back(state);
        }
        EXPECT_EQ(states[0], states[1]);
    }
}

// The callback of one world pushes a body of a later one, and draws a random number.
TEST_P(StepWorlds, OneOfWhichCallsTheProgram) {
    static Worlds *pushed;
    static int calls;
    calls = 0;
    expectLoop(dWorldQuickStep, [](Worlds &worlds) {
        pushed = &worlds;
        dBodySetMovedCallback(worlds.chains(17).bodies()[1], [](dBodyID) {
            ++calls;
            dRand();
            dBodyAddForce(pushed->chains(30).bodies()[0], 1, 2, 3);
        });
    });
    EXPECT_EQ(calls, 2 * kSteps);
}

// A later world overwrites what an earlier one has written.
TEST_P(StepWorlds, WhoseJointsShareFeedback) {
    static dJointFeedback shared;
    const auto share = [](Worlds &worlds) {
        for (unsigned i = 0; i < worlds.count(); ++i) dJointSetFeedback(worlds.chains(i).joints()[0], &shared);
    };
    expectLoop(dWorldStep, share);
    const dJointFeedback ofTogether = shared;
    Worlds looped(dWorldStep);
    share(looped);
    for (int i = 0; i < kSteps; ++i) looped.stepOneByOne();
    for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(shared.f1[axis], ofTogether.f1[axis]);
}

TEST_P(StepWorlds, ThatShareWorkingMemory) {
    expectLoop(dWorldQuickStep, [](Worlds &worlds) {
        for (unsigned i = 1; i < worlds.count(); i += 3) dWorldUseSharedWorkingMemory(worlds.world(i), worlds.world(0));
    });
}

TEST_P(StepWorlds, WithThreadsOfTheirOwn) {
    expectLoop(dWorldQuickStep, [](Worlds &worlds) {
        dODE_MT_SetWorldThreads(worlds.world(5), 1);
        dODE_MT_SetWorldThreads(worlds.world(6), 3);
        dWorldSetStepIslandsProcessingMaxThreadCount(worlds.world(9), 1);
    });
}

// Which may look at any world.
TEST_P(StepWorlds, WithAHandlerOfMessages) {
    dSetMessageHandler(keepLastMessage);
    expectLoop(dWorldQuickStep, [](Worlds &) {});
    dSetMessageHandler(nullptr);
}

TEST_P(StepWorlds, FallAsleepAsInALoop) {
    expectLoop(dWorldStep, [](Worlds &worlds) {
        for (unsigned i = 0; i < worlds.count(); i += 2) {
            dWorldSetGravity(worlds.world(i), 0, 0, 0);
            for (const dBodyID body : worlds.chains(i).bodies()) {
                dBodySetLinearVel(body, 0, 0, 0);
                dBodySetAngularVel(body, 0, 0, 0);
                dBodySetAutoDisableFlag(body, 1);
                dBodySetAutoDisableSteps(body, 5);
            }
        }
    });
}

INSTANTIATE_TEST_SUITE_P(Ways, StepWorlds,
                         testing::Values(Way{0, "auto"}, Way{1, "auto"}, Way{2, "auto"}, Way{2, "lcp"}, Way{3, "lcp"}, Way{8, "lcp"},
                                         Way{8, "serial"}),
                         [](const auto &info) { return info.param.algorithm + std::to_string(info.param.threads); });

TEST(StepWorldsAlone, AreSharedOut) {
    const OdeSession session(3, "lcp");
    dODE_MT_NoteBodyWorkers(1);
    Worlds worlds(dWorldQuickStep, 200);
    using Clock = std::chrono::steady_clock;
    const Clock::time_point end = Clock::now() + std::chrono::seconds(60);
    do {
        worlds.stepTogether();
    } while (worlds.workers().size() < 2 && Clock::now() < end);
    dODE_MT_NoteBodyWorkers(0);
    EXPECT_GE(worlds.workers().size(), 2u);
    EXPECT_EQ(worlds.workers().count(-1), 0u) << "a body was not stepped";
}

// Each world's steps are counted, and the reason says how they went.
TEST(StepWorldsAlone, AreCounted) {
    const OdeSession session(2, "lcp");
    Worlds worlds(dWorldStep, 10);
    dODE_MT_WorldStatistics statistics{};
    statistics.size = sizeof statistics;
    dODE_MT_GetWorldStatistics(worlds.world(3), &statistics);
    for (int i = 0; i < 3; ++i) worlds.stepTogether();
    ASSERT_EQ(dODE_MT_GetWorldStatistics(worlds.world(3), &statistics), 1);
    EXPECT_EQ(statistics.frames, 3u);
    EXPECT_EQ(statistics.stepReason, dODE_MT_REASON_WORLDS);
    EXPECT_EQ(statistics.stepThreads, 1u);
    EXPECT_GT(statistics.stepTime, 0);
    // Numbers are in the order of the list, whoever was first.
    const unsigned number = statistics.number;
    for (int i = 0; i < 10; ++i) {
        ASSERT_EQ(dODE_MT_GetWorldStatistics(worlds.world(i), &statistics), 1);
        EXPECT_EQ(statistics.number, number - 3 + i);
    }
}

TEST(StepWorldsAlone, NothingIsSteppedWhereAWorldStandsTwice) {
    const OdeSession session(2, "lcp");
    const ChainWorld one(2, 2), other(1, 2);
    const std::vector<dReal> before = one.state();
    const dWorldID twice[] = {one.world(), other.world(), one.world()};
    dSetMessageHandler(keepLastMessage);
    EXPECT_EQ(dODE_MT_StepWorlds(twice, 3, "quick", REAL(0.01)), 0);
    EXPECT_EQ(lastMessage, "ODE_MT: world 2 of 3 stands in the list before");
    EXPECT_EQ(dODE_MT_StepWorlds(twice, -1, "quick", REAL(0.01)), 0);
    EXPECT_EQ(lastMessage, "ODE_MT: no list of -1 worlds; known: 0 and more");
    EXPECT_EQ(dODE_MT_StepWorlds(twice, 2, "Quick", REAL(0.01)), 0);
    EXPECT_EQ(lastMessage, "ODE_MT: no stepper 'Quick'; known: step, quick");
    EXPECT_EQ(dODE_MT_StepWorlds(nullptr, 0, "step", REAL(0.01)), 1);
    EXPECT_EQ(dODE_MT_StepWorlds(nullptr, 0, "step", -1), 1);
    dSetMessageHandler(nullptr);
    EXPECT_EQ(one.state(), before);
}

// A body that spins with NaN ends the process with upstream's text, whatever comes behind it: another one, or a world whose step never ends.
TEST(StepWorldsAlone, AnErrorEndsTheProcessInItsTurn) {
    const auto end = [](bool isTogether) {
        return support::runInChild([isTogether] {
            const OdeSession session(4, "lcp");
            Worlds worlds(dWorldQuickStep, 30);
            for (const unsigned broken : {7u, 21u}) {
                const dBodyID body = dBodyCreate(worlds.world(broken));
                dBodySetAngularVel(body, std::numeric_limits<dReal>::quiet_NaN(), 0, 0);
            }
            dWorldSetQuickStepNumIterations(worlds.world(25), -1);
            isTogether ? static_cast<void>(worlds.stepTogether()) : worlds.stepOneByOne();
        });
    };
    const support::Ending looped = end(false), together = end(true);
    EXPECT_EQ(together.status, looped.status);
    EXPECT_TRUE(together.killedBy(SIGABRT));
    EXPECT_EQ(together.errors, looped.errors);
}

}  // namespace
