// Whole steps of worlds whose solver is "fast": velocities are those of "exact", bits are the same for every number of threads and
// instruction set, what cannot be solved is left to the exact solver, and other worlds are as ever.
#include <gtest/gtest.h>

#include <ode/ode.h>

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstdarg>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "brick_wall.h"
#include "../frame/OdeSession.h"
#include "instruction_sets.h"
#include "joint_world.h"
#include "kept_messages.h"
#include "random_world.h"
#include "robot_world.h"

namespace {

constexpr dReal kStepSize = dReal(0.01);

class FastWorldStep : public testing::Test {
    const OdeSession m_session;
};

struct Counts {
    unsigned islands = dODE_MT_GetDirectIslands(), fallbacks = dODE_MT_GetDirectFallbacks();

    unsigned newIslands() const { return dODE_MT_GetDirectIslands() - islands; }
    unsigned newFallbacks() const { return dODE_MT_GetDirectFallbacks() - fallbacks; }
};

// To nine digits of the largest velocity, but not to the bit, as if the direct solver had not been asked.
void expectSame(const std::vector<dReal> &expected, const std::vector<dReal> &found) {
    double largest = 0, difference = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        largest = std::max(largest, std::fabs(double(expected[i])));
        difference = std::max(difference, std::fabs(double(expected[i]) - double(found[i])));
    }
    EXPECT_GT(largest, 0);
    EXPECT_LE(difference, 1e-9 * largest);
    EXPECT_NE(expected, found);
}

// One step of a wall by each solver.
void expectSameVelocities(const BrickWall::Shape &shape) {
    const Counts counts;
    BrickWall exact(shape), fast(shape);
    ASSERT_EQ(dODE_MT_SetSolver(fast.world(), "fast"), 1);
    for (BrickWall *wall : {&exact, &fast}) {
        wall->collide();
        wall->step();
    }
    EXPECT_GT(fast.contacts(), 100u);
    EXPECT_EQ(counts.newIslands(), 1u);
    EXPECT_EQ(counts.newFallbacks(), 0u);
    expectSame(exact.velocities(), fast.velocities());
}

TEST_F(FastWorldStep, MovesAWallAsTheExactStep) { expectSameVelocities({}); }

TEST_F(FastWorldStep, MovesAWallOnAMovingFloorAsTheExactStep) {
    BrickWall::Shape shape;
    shape.hasMovingFloor = true;
    expectSameVelocities(shape);
}

TEST_F(FastWorldStep, MovesAWallOfInfiniteFrictionAsTheExactStep) {
    BrickWall::Shape shape;
    shape.mu = dInfinity;
    shape.cfm = dReal(1e-4);
    expectSameVelocities(shape);
}

TEST_F(FastWorldStep, MovesAWallWithFixedFrictionLimitsAsTheExactStep) {
    BrickWall::Shape shape;
    shape.mu = 1000;  // N
    shape.hasApproximation = false;
    shape.cfm = dReal(1e-4);  // harder ones are beyond upstream's algorithm
    expectSameVelocities(shape);
}

// Islands whose rows without limits are eliminated: small and large robots, standing and in the air, with hard joints and soft ones.
TEST_F(FastWorldStep, MovesRobotsAsTheExactStep) {
    const RobotWorld::Shape shapes[] = {{1, 9, 4}, {1, 17, 8}, {1, 17, 0}, {3, 30, 20}, {1, 17, 8, 0}, {1, 17, 8, dReal(1e-4)}, {1, 100, 12}};
    for (const RobotWorld::Shape &shape : shapes)
        for (unsigned seed = 0; seed < 10; ++seed) {
            const Counts counts;
            RobotWorld exact(shape, seed), fast(shape, seed);
            dODE_MT_SetSolver(fast.world(), "fast");
            for (RobotWorld *robots : {&exact, &fast}) dWorldStep(robots->world(), kStepSize);
            EXPECT_EQ(counts.newIslands(), shape.robots);
            EXPECT_EQ(counts.newFallbacks(), 0u);
            expectSame(exact.velocities(), fast.velocities());
        }
}

// A chain without limits is one linear system, whatever its length.
void expectSameChain(unsigned links) {
    std::vector<std::vector<dReal>> velocities;
    const Counts counts;
    for (const char *solver : {"exact", "fast"}) {
        const dWorldID world = dWorldCreate();
        dWorldSetGravity(world, 0, 0, -10);
        dODE_MT_SetSolver(world, solver);
        std::vector<dBodyID> chain;
        for (unsigned i = 0; i < links; ++i) {
            chain.push_back(dBodyCreate(world));
            dBodySetPosition(chain.back(), i, std::sin(dReal(i)), std::cos(dReal(i)));
            const dJointID joint = dJointCreateBall(world, nullptr);
            dJointAttach(joint, chain.back(), i > 0 ? chain[i - 1] : nullptr);
            dJointSetBallAnchor(joint, dReal(i) - dReal(0.5), 0, 0);
        }
        dWorldStep(world, kStepSize);
        std::vector<dReal> &all = velocities.emplace_back();
        for (const dBodyID link : chain) all.insert(all.end(), dBodyGetLinearVel(link), dBodyGetLinearVel(link) + 3);
        dWorldDestroy(world);
    }
    EXPECT_EQ(counts.newIslands(), 1u);
    EXPECT_EQ(counts.newFallbacks(), 0u);
    expectSame(velocities[0], velocities[1]);
}

TEST_F(FastWorldStep, MovesAChainAsTheExactStep) {
    expectSameChain(100);
    expectSameChain(400);
}

// What is told of a chain, and who hears of it, changes nothing: forces of joints with feedback are those of the exact step, and a body
// with a callback, by which others are moved one by one, has the bits that it has without.
TEST_F(FastWorldStep, TellsOfAChain) {
    const auto step = [](const char *solver, dJointFeedback *feedback, void (*callback)(dBodyID)) {
        JointWorld world(solver);
        world.addChain(100);
        dJointSetFeedback(dBodyGetJoint(world.bodies()[40], 0), feedback);
        dBodySetMovedCallback(world.bodies()[60], callback);
        for (int i = 0; i < 3; ++i) dWorldStep(world.world(), kStepSize);
        return world.velocities();
    };
    static unsigned calls;
    calls = 0;
    dJointFeedback exact{}, fast{};
    const std::vector<dReal> expected = step("exact", &exact, nullptr), found = step("fast", &fast, nullptr);
    expectSame(expected, found);
    EXPECT_NE(exact.f1[2], 0);
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(exact.f1[axis], fast.f1[axis], 1e-6 * std::fabs(exact.f1[2]));
    const std::vector<dReal> plain = step("fast", nullptr, nullptr);
    expectSame(expected, plain);
    EXPECT_EQ(step("fast", nullptr, [](dBodyID) { ++calls; }), plain);
    EXPECT_EQ(calls, 3u);
}

// A structure that is kept is another island's: chains and trees of as many joints, one after another.
TEST_F(FastWorldStep, ForgetsTheStructureOfTheLastIsland) {
    const auto stepAfter = [](unsigned nets) {
        for (unsigned i = 0; i < nets; ++i) {
            JointWorld other("fast");
            other.addNet(7);
            dWorldStep(other.world(), kStepSize);
        }
        JointWorld world("fast");
        world.addChain(84);  // as many joints as the net has
        for (int i = 0; i < 2; ++i) dWorldStep(world.world(), kStepSize);
        return world.velocities();
    };
    const std::vector<dReal> first = stepAfter(0);
    EXPECT_EQ(stepAfter(1), first);
    EXPECT_EQ(stepAfter(0), first);
}

// One step by each solver. Returns the velocities of both.
template <class Add>
std::vector<std::vector<dReal>> velocitiesOfBoth(const Add &add) {
    std::vector<std::vector<dReal>> velocities;
    for (const char *solver : {"exact", "fast"}) {
        JointWorld world(solver);
        add(world);
        dWorldStep(world.world(), kStepSize);
        velocities.push_back(world.velocities());
    }
    return velocities;
}

// Rays of a small star are dense rows for Dantzig's algorithm: nothing is to be gained, and bits are those of "exact".
TEST_F(FastWorldStep, LeavesSmallStarsToTheExactStep) {
    for (const unsigned rays : {5u, 14u, 30u}) {
        const Counts counts;
        const auto velocities = velocitiesOfBoth([&](JointWorld &world) { world.addStar(rays); });
        EXPECT_EQ(counts.newIslands(), 0u) << rays;
        EXPECT_EQ(velocities[0], velocities[1]) << rays;
    }
}

// In the space of bodies a hub is one block.
TEST_F(FastWorldStep, MovesLargeStarsAndWheelsAsTheExactStep) {
    for (const unsigned rays : {100u, 250u}) {
        const Counts counts;
        const auto star = velocitiesOfBoth([&](JointWorld &world) { world.addStar(rays); });
        expectSame(star[0], star[1]);
        const auto wheel = velocitiesOfBoth([&](JointWorld &world) { world.addWheel(rays); });
        expectSame(wheel[0], wheel[1]);
        EXPECT_EQ(counts.newIslands(), 2u) << rays;
        EXPECT_EQ(counts.newFallbacks(), 0u) << rays;
    }
}

// Small ones by columns of blocks, large ones by fronts; of ball joints alone, and of several types.
TEST_F(FastWorldStep, MovesNetsAsTheExactStep) {
    for (const unsigned side : {8u, 22u})
        for (const bool hasHinges : {false, true}) {
            const Counts counts;
            const auto velocities = velocitiesOfBoth([&](JointWorld &world) { world.addNet(side, hasHinges); });
            EXPECT_EQ(counts.newIslands(), 1u);
            EXPECT_EQ(counts.newFallbacks(), 0u);
            expectSame(velocities[0], velocities[1]);
        }
}

// Bodies that fall together have a b that is the small rest of large velocities, and no larger error than rounding leaves in these.
TEST_F(FastWorldStep, SolvesWhatFalls) {
    const Counts counts;
    for (const dReal velocity : {dReal(-1), dReal(-30), dReal(-1000)}) {
        const auto net = velocitiesOfBoth([&](JointWorld &world) {
            world.addNet(8);
            world.push(velocity);
        });
        expectSame(net[0], net[1]);
        const auto star = velocitiesOfBoth([&](JointWorld &world) {
            world.addStar(250);
            world.push(velocity);
        });
        expectSame(star[0], star[1]);
    }
    EXPECT_EQ(counts.newIslands(), 6u);
    EXPECT_EQ(counts.newFallbacks(), 0u);
}

// Where forces are not unique, the residual is what counts: nothing is left to the exact solver.
TEST_F(FastWorldStep, SolvesHardContacts) {
    BrickWall::Shape shape;
    shape.cfm = 0;
    BrickWall wall(shape);
    dODE_MT_SetSolver(wall.world(), "fast");
    const Counts counts;
    for (int i = 0; i < 20; ++i) {
        wall.collide();
        wall.step();
    }
    EXPECT_EQ(counts.newIslands(), 20u);
    EXPECT_EQ(counts.newFallbacks(), 0u);
    for (const dReal velocity : wall.velocities()) EXPECT_LT(std::fabs(velocity), 10);
}

// A chain of ball joints, each of them there twice with anchors apart: hard rows that contradict one another have no solution.
TEST_F(FastWorldStep, StepsOnWhereHardRowsContradictOneAnother) {
    const dWorldID world = dWorldCreate();
    dWorldSetCFM(world, 0);
    dWorldSetGravity(world, 0, 0, -10);
    dODE_MT_SetSolver(world, "fast");
    std::vector<dBodyID> links;
    for (int i = 0; i < 150; ++i) {
        links.push_back(dBodyCreate(world));
        dBodySetPosition(links.back(), i, 0, 0);
        for (const dReal apart : {0, 1}) {
            const dJointID joint = dJointCreateBall(world, nullptr);
            dJointAttach(joint, links.back(), i > 0 ? links[i - 1] : nullptr);
            dJointSetBallAnchor(joint, dReal(i - 0.5), 0, 0);
            if (apart > 0) dJointSetBallAnchor2(joint, dReal(i - 0.4), 0, 0);
        }
    }
    const Counts counts;
    EXPECT_EQ(dWorldStep(world, kStepSize), 1);
    EXPECT_EQ(counts.newIslands(), 1u);
    EXPECT_LE(counts.newFallbacks(), 1u);
    for (const dBodyID link : links) EXPECT_LT(std::fabs(dBodyGetLinearVel(link)[2]), 10);
    dWorldDestroy(world);
}

// A problem that is not convex, where rows become softer the more they are pressed: with the exact solver's bits, and counted.
TEST_F(FastWorldStep, LeavesWhatItCannotSolveToTheExactStep) {
    BrickWall::Shape shape;
    shape.cfm = dReal(-1e-9);
    shape.side = 4;
    BrickWall exact(shape), fast(shape);
    dODE_MT_SetSolver(fast.world(), "fast");
    const Counts counts;
    for (BrickWall *wall : {&exact, &fast}) {
        wall->collide();
        wall->step();
    }
    EXPECT_EQ(counts.newIslands(), 1u);
    EXPECT_EQ(counts.newFallbacks(), 1u);
    EXPECT_EQ(exact.velocities(), fast.velocities());
}

// Islands of all sizes with joints of all types, before and after the direct solver's least one.
std::vector<std::uint64_t> stateAfterSteps(unsigned threads, const char *solver, const char *algorithm = "lcp") {
    dToggleODE_MT(static_cast<int>(threads));
    dODE_MT_SetAlgorithm(algorithm);
    std::vector<std::uint64_t> all;
    for (const RandomWorld::Shape shape : {RandomWorld::Shape{80, 240}, {300, 200}}) {
        RandomWorld world(shape, 3);
        dODE_MT_SetSolver(world.world(), solver);
        for (int i = 0; i < 5; ++i) {
            world.push();
            dWorldStep(world.world(), kStepSize);
        }
        const std::vector<std::uint64_t> state = world.state();
        all.insert(all.end(), state.begin(), state.end());
    }
    RobotWorld robots({8, 17, 8}, 3);
    dODE_MT_SetSolver(robots.world(), solver);
    JointWorld others(solver);
    for (const unsigned rays : {14u, 120u}) {
        others.addStar(rays);
        others.addWheel(rays);
    }
    for (const unsigned side : {6u, 24u})
        for (const bool hasHinges : {false, true}) others.addNet(side, hasHinges);
    for (int i = 0; i < 5; ++i) {
        dWorldStep(robots.world(), kStepSize);
        dWorldStep(others.world(), kStepSize);
    }
    for (const std::vector<dReal> &velocities : {robots.velocities(), others.velocities()})
        for (const dReal velocity : velocities) {
            std::uint64_t bits = 0;
            std::memcpy(&bits, &velocity, sizeof velocity);
            all.push_back(bits);
        }
    return all;
}

// Numbers that are not finite are the exact solver's, too.
TEST_F(FastWorldStep, LeavesNumbersThatAreNotFiniteToTheExactStep) {
    dSetMessageHandler(keepMessage);
    dSetDebugHandler(keepMessageAndLeave);
    for (const dReal velocity : {dInfinity, dReal(NAN)}) {
        BrickWall::Shape shape;
        shape.side = 4;
        BrickWall exact(shape), fast(shape);
        dODE_MT_SetSolver(fast.world(), "fast");
        const Counts counts;
        std::vector<std::string> messages;
        for (BrickWall *wall : {&exact, &fast}) {
            keptMessages.clear();
            wall->collide();
            dBodySetLinearVel(wall->bricks()[3], velocity, 0, 0);
            EXPECT_THROW(wall->step(), std::runtime_error) << velocity;  // upstream asserts its quaternions
            messages.push_back(keptMessages);
        }
        EXPECT_EQ(messages[0], messages[1]);
        EXPECT_EQ(counts.newIslands(), 1u) << velocity;
        EXPECT_EQ(counts.newFallbacks(), 1u) << velocity;
        const std::vector<dReal> expected = exact.velocities(), found = fast.velocities();
        for (std::size_t i = 0; i < expected.size(); ++i)
            EXPECT_TRUE(expected[i] == found[i] || (std::isnan(expected[i]) && std::isnan(found[i]))) << velocity << ' ' << i;
    }
    dSetMessageHandler(nullptr);
    dSetDebugHandler(nullptr);
}

std::jmp_buf g_outOfTheStep;
unsigned g_messages;

// Dantzig's algorithm reports that it gives up. The handler leaves the step: nothing of ours is stranded, later steps are as ever, and
// later messages are told.
TEST_F(FastWorldStep, MayBeLeftByAMessageHandler) {
    BrickWall::Shape shape;
    shape.side = 4;
    const std::vector<std::uint64_t> before = stateAfterSteps(0, "fast");
    dSetMessageHandler([](int, const char *, va_list) {
        ++g_messages;
        std::longjmp(g_outOfTheStep, 1);
    });
    g_messages = 0;
    for (int i = 0; i < 3; ++i) {
        shape.cfm = dReal(-1e-2);
        BrickWall wall(shape);
        dODE_MT_SetSolver(wall.world(), "fast");
        wall.collide();
        if (setjmp(g_outOfTheStep) == 0) {
            wall.step();
            ADD_FAILURE() << "no message";
        }
    }
    dSetMessageHandler(nullptr);
    EXPECT_EQ(g_messages, 3u);
    EXPECT_EQ(stateAfterSteps(0, "fast"), before);
}

TEST_F(FastWorldStep, HasTheSameBitsForEveryNumberOfThreads) {
    const Counts counts;
    const std::vector<std::uint64_t> serial = stateAfterSteps(0, "fast", "serial");
    EXPECT_GE(counts.newIslands(), 5u);
    EXPECT_GE(counts.newIslands() - counts.newFallbacks(), 40u + 15u);  // all robots, the large star and wheel, the net
    for (const unsigned threads : {1u, 2u, 3u, 8u}) EXPECT_EQ(stateAfterSteps(threads, "fast"), serial) << threads << " threads";
    EXPECT_NE(stateAfterSteps(0, "exact"), serial);
}

// A large island in body space, whose factorisation has a top. Returns whether a second worker took part in each step.
bool stepLargeWall(unsigned threads, const char *algorithm, std::vector<dReal> &velocities) {
    dToggleODE_MT(static_cast<int>(threads));
    dODE_MT_SetAlgorithm(algorithm);
    BrickWall::Shape shape;
    shape.side = 14;
    BrickWall wall(shape);
    dODE_MT_SetSolver(wall.world(), "fast");
    const unsigned before = dODE_MT_GetTeamSteps();
    constexpr unsigned kSteps = 2;
    for (unsigned i = 0; i < kSteps; ++i) {
        wall.collide();
        wall.step();
    }
    velocities = wall.velocities();
    return dODE_MT_GetTeamSteps() == before + kSteps;
}

// A worker that comes late finds nothing left to do, so each is tried until it has come in time.
TEST_F(FastWorldStep, HasTheSameBitsForEveryNumberOfWorkersOfALargeIsland) {
    std::vector<dReal> serial, velocities;
    EXPECT_FALSE(stepLargeWall(0, "serial", serial));
    for (const unsigned threads : {1u, 2u, 3u, 5u, 8u, 16u}) {
        constexpr unsigned kTries = 50;
        bool isShared = false;
        for (unsigned i = 0; i < kTries && !isShared; ++i) {
            isShared = stepLargeWall(threads, "lcp", velocities);
            EXPECT_EQ(velocities, serial) << threads << " threads";
            if (threads < 2) break;
        }
        EXPECT_EQ(isShared, threads >= 2) << threads << " threads";
    }
    for (unsigned i = 0; i < 5; ++i) {
        stepLargeWall(2, "auto", velocities);
        EXPECT_EQ(velocities, serial);
    }
}

TEST_F(FastWorldStep, HasTheSameBitsOnEveryInstructionSet) {
    std::vector<std::uint64_t> first;
    for (const std::int64_t set : instructionSets())
        onInstructionSet(set, [&] {
            const std::vector<std::uint64_t> state = stateAfterSteps(0, "fast");
            if (first.empty()) first = state;
            EXPECT_EQ(state, first);
        });
}

// A step that follows others has the bits of one in a new process: nothing is kept that counts.
TEST_F(FastWorldStep, HasTheSameBitsEachTime) {
    const std::vector<std::uint64_t> first = stateAfterSteps(0, "fast");
    expectSameVelocities({});
    EXPECT_EQ(stateAfterSteps(0, "fast"), first);
}

// Large enough for the direct solver.
class SmallWall : public BrickWall {
public:
    explicit SmallWall(const char *solver) : BrickWall(shape()) { dODE_MT_SetSolver(world(), solver); }

private:
    static Shape shape() {
        Shape shape;
        shape.side = 4;
        return shape;
    }
};

// A moved-callback attaches a joint to a wall that is still to be stepped: that island is upstream's, in memory of its own.
TEST_F(FastWorldStep, LeavesIslandsThatChangeDuringTheStepToUpstream) {
    static dBodyID brick;
    std::vector<std::vector<dReal>> velocities;
    const Counts counts;
    for (const char *solver : {"exact", "fast"}) {
        SmallWall wall(solver);
        brick = wall.bricks()[5];
        const dBodyID mover = dBodyCreate(wall.world());  // the last body of a world is the first one in its list
        dBodySetPosition(mover, 50, 0, 5);
        dBodySetMovedCallback(mover, [](dBodyID body) {
            const dJointID joint = dJointCreateBall(dBodyGetWorld(body), nullptr);
            dJointAttach(joint, brick, nullptr);
            dJointSetBallAnchor(joint, 0, 0, 1);
            dBodySetMovedCallback(body, nullptr);
        });
        wall.collide();
        EXPECT_GT(wall.contacts(), 60u);
        wall.step();
        velocities.push_back(wall.velocities());
    }
    EXPECT_EQ(velocities[0], velocities[1]);
    EXPECT_EQ(counts.newIslands(), 0u);
}

// Functions of the user's are asked for all that upstream asks of them.
TEST_F(FastWorldStep, LeavesWorldsOfTheUsersThreadingFunctionsToUpstream) {
    const dThreadingImplementationID implementation = dThreadingAllocateSelfThreadedImplementation();
    const dThreadingFunctionsInfo functions = *dThreadingImplementationGetFunctions(implementation);
    std::vector<std::vector<dReal>> velocities;
    const Counts counts;
    for (const char *solver : {"exact", "fast"}) {
        SmallWall wall(solver);
        dWorldSetStepThreadingImplementation(wall.world(), &functions, implementation);
        wall.collide();
        wall.step();
        velocities.push_back(wall.velocities());
        dWorldSetStepThreadingImplementation(wall.world(), nullptr, nullptr);
    }
    dThreadingFreeImplementation(implementation);
    EXPECT_EQ(velocities[0], velocities[1]);
    EXPECT_EQ(counts.newIslands(), 0u);
}

std::vector<size_t> g_requests;

// The user's memory manager is asked for the rows, not for a matrix of rows by rows.
TEST_F(FastWorldStep, TakesNoMemoryForAMatrix) {
    std::size_t largest[2] = {0, 0};
    BrickWall::Shape shape;
    shape.side = 10;
    for (const bool isFast : {false, true}) {
        BrickWall wall(shape);
        dODE_MT_SetSolver(wall.world(), isFast ? "fast" : "exact");
        dWorldStepMemoryFunctionsInfo functions = {sizeof functions, nullptr, nullptr, nullptr};
        functions.alloc_block = [](dsizeint size) {
            g_requests.push_back(size);
            return std::malloc(size);
        };
        functions.shrink_block = [](void *block, dsizeint, dsizeint size) { return std::realloc(block, size); };
        functions.free_block = [](void *block, dsizeint) { std::free(block); };
        dWorldSetStepMemoryManager(wall.world(), &functions);
        g_requests.clear();
        wall.collide();
        wall.step();
        largest[isFast] = *std::max_element(g_requests.begin(), g_requests.end());
    }
    EXPECT_LT(largest[1] * 4, largest[0]);
}

}  // namespace
