// dWorldQuickStep of worlds whose solver is "fast": the same bits for every number of threads and instruction set, and for a
// world made anew from a saved state; forces of the last step found again; what is not solved so is left to upstream. How good
// its results are is judged in tests/quality.
//
// Covers dxContactCache.cpp, dxContactReader.cpp, dxFastQuickStepState.cpp, dxPgsSolver.cpp, dxRowConstraints.cpp.
#include <gtest/gtest.h>

#include <ode/ode.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <deque>
#include <memory>
#include <random>
#include <vector>

#include "config.h"
#include "objects.h"

#include "../frame/OdeSession.h"
#include "body_velocities.h"
#include "instruction_sets.h"
#include "random_world.h"

namespace {

constexpr dReal kStepSize = dReal(0.01);

class FastQuickStep : public testing::Test {
    const OdeSession m_session;
};

// Boxes that fall into a heap, stacks beside it, and a wheel on a hinge with a motor.
class Yard {
public:
    explicit Yard(const char *solver, bool isWarm = true)
        : m_world(dWorldCreate()), m_space(dHashSpaceCreate(nullptr)), m_contacts(dJointGroupCreate(0)) {
        dODE_MT_SetSolver(m_world, solver);
        dODE_MT_SetWarmStart(m_world, isWarm);
        dWorldSetGravity(m_world, 0, 0, -10);
        dCreatePlane(m_space, 0, 0, 1, 0);
        for (int i = 0; i < 450; ++i)
            addBox(dReal(i % 5) + dReal(0.1) * dReal(i % 3), dReal(i / 5 % 5) + dReal(0.07) * dReal(i % 4),
                   dReal(0.6) + dReal(1.05) * dReal(i / 25));
        for (int i = 0; i < 200; ++i) addBox(3 * dReal(i / 5), -500, dReal(0.5) + dReal(i % 5));
        addWheel();
    }
    ~Yard() {
        dJointGroupDestroy(m_contacts);
        dSpaceDestroy(m_space);
        dWorldDestroy(m_world);
    }
    Yard(const Yard &) = delete;
    Yard &operator=(const Yard &) = delete;

    void step(int count = 1) {
        for (int i = 0; i < count; ++i) {
            m_contactCount = 0;
            dSpaceCollide(m_space, this, [](void *data, dGeomID a, dGeomID b) { static_cast<Yard *>(data)->meet(a, b); });
            dWorldQuickStep(m_world, kStepSize);
            dJointGroupEmpty(m_contacts);
        }
    }

    // Poses and velocities; bits.
    std::vector<std::uint64_t> state() const {
        std::vector<std::uint64_t> all;
        for (const dBodyID body : m_bodies)
            for (const auto &[numbers, count] : fieldsOf(body))
                for (int i = 0; i < count; ++i) {
                    const double number = numbers[i];
                    std::uint64_t bits;
                    std::memcpy(&bits, &number, sizeof bits);
                    all.push_back(bits);
                }
        return all;
    }

    // Another yard's bodies stand and move as this one's, and its geoms have been moved in the order of the bodies.
    void copyTo(Yard &other) const {
        dSpaceClean(other.m_space);
        for (std::size_t i = 0; i < m_bodies.size(); ++i) {
            const dBodyID from = m_bodies[i], to = other.m_bodies[i];
            const dReal *const at = dBodyGetPosition(from), *const moves = dBodyGetLinearVel(from),
                               *const turns = dBodyGetAngularVel(from);
            dBodySetPosition(to, at[0], at[1], at[2]);
            std::memcpy(const_cast<dReal *>(dBodyGetQuaternion(to)), dBodyGetQuaternion(from),
                        4 * sizeof(dReal));  // unlike dBodySetQuaternion, not normalised anew
            std::memcpy(const_cast<dReal *>(dBodyGetRotation(to)), dBodyGetRotation(from), 12 * sizeof(dReal));
            dBodySetLinearVel(to, moves[0], moves[1], moves[2]);
            dBodySetAngularVel(to, turns[0], turns[1], turns[2]);
        }
    }

    dWorldID world() const { return m_world; }
    dBodyID body(std::size_t i) const { return m_bodies[i]; }
    unsigned contactCount() const { return m_contactCount; }
    double energyOfStacks() const {
        double sum = 0;
        for (std::size_t i = 450; i < 650; ++i) {
            const dReal *const v = dBodyGetLinearVel(m_bodies[i]), *const w = dBodyGetAngularVel(m_bodies[i]);
            for (int axis = 0; axis < 3; ++axis) sum += double(v[axis]) * v[axis] + double(w[axis]) * w[axis] / 6;
        }
        return sum / 2;
    }

private:
    static std::array<std::pair<const dReal *, int>, 4> fieldsOf(dBodyID body) {
        return {{{dBodyGetPosition(body), 3},
                 {dBodyGetQuaternion(body), 4},
                 {dBodyGetLinearVel(body), 3},
                 {dBodyGetAngularVel(body), 3}}};
    }

    void addBox(dReal x, dReal y, dReal z) {
        const dBodyID body = dBodyCreate(m_world);
        dMass mass;
        dMassSetBoxTotal(&mass, 1, 1, 1, 1);
        dBodySetMass(body, &mass);
        dBodySetPosition(body, x, y, z);
        dGeomSetBody(dCreateBox(m_space, 1, 1, 1), body);
        m_bodies.push_back(body);
    }

    void addWheel() {
        addBox(-10, 0, 3);
        const dJointID hinge = dJointCreateHinge(m_world, nullptr);
        dJointAttach(hinge, m_bodies.back(), nullptr);
        dJointSetHingeAnchor(hinge, -10, 0, 3);
        dJointSetHingeAxis(hinge, 0, 1, 0);
        dJointSetHingeParam(hinge, dParamVel, 2);
        dJointSetHingeParam(hinge, dParamFMax, 5);
    }

    void meet(dGeomID a, dGeomID b) {
        dContact contacts[8];
        const int count = dCollide(a, b, 8, &contacts[0].geom, sizeof contacts[0]);
        for (int i = 0; i < count; ++i) {
            contacts[i].surface.mode = dContactApprox1;
            contacts[i].surface.mu = dReal(0.6);
            dJointAttach(dJointCreateContact(m_world, m_contacts, &contacts[i]), dGeomGetBody(a), dGeomGetBody(b));
        }
        m_contactCount += static_cast<unsigned>(count);
    }

    dWorldID m_world;
    dSpaceID m_space;
    dJointGroupID m_contacts;
    std::vector<dBodyID> m_bodies;
    unsigned m_contactCount = 0;
};

std::vector<std::uint64_t> yardAfter(int steps, unsigned threads, const char *algorithm = "lcp") {
    dToggleODE_MT(static_cast<int>(threads));
    dODE_MT_SetAlgorithm(algorithm);
    Yard yard("fast");
    yard.step(steps);
    EXPECT_GT(yard.contactCount(), 1500u);
    return yard.state();
}

// Islands of all sizes with joints of all types.
std::vector<std::uint64_t> randomWorldsAfterSteps(unsigned threads, const char *algorithm = "lcp") {
    dToggleODE_MT(static_cast<int>(threads));
    dODE_MT_SetAlgorithm(algorithm);
    std::vector<std::uint64_t> all;
    for (const RandomWorld::Shape shape : {RandomWorld::Shape{80, 240}, {300, 200}, {400, 1600}}) {
        RandomWorld world(shape, 3);
        dODE_MT_SetSolver(world.world(), "fast");
        for (int i = 0; i < 5; ++i) {
            world.push();
            dWorldQuickStep(world.world(), kStepSize);
        }
        const std::vector<std::uint64_t> state = world.state();
        all.insert(all.end(), state.begin(), state.end());
    }
    return all;
}

TEST_F(FastQuickStep, HasTheSameBitsForEveryNumberOfThreads) {
    const std::vector<std::uint64_t> yard = yardAfter(70, 0, "serial"), worlds = randomWorldsAfterSteps(0, "serial");
    for (const unsigned threads : {1u, 2u, 3u, 5u, 8u}) {
        const unsigned before = dODE_MT_GetTeamSteps();
        EXPECT_EQ(yardAfter(70, threads), yard) << threads << " threads";
        EXPECT_EQ(randomWorldsAfterSteps(threads), worlds) << threads << " threads";
        if (threads > 1) EXPECT_GT(dODE_MT_GetTeamSteps(), before);
    }
}

TEST_F(FastQuickStep, HasTheSameBitsOnEveryInstructionSet) {
    std::vector<std::uint64_t> first;
    for (const std::int64_t set : instructionSets())
        onInstructionSet(set, [&] {
            std::vector<std::uint64_t> state = yardAfter(60, 0);
            const std::vector<std::uint64_t> worlds = randomWorldsAfterSteps(0);
            state.insert(state.end(), worlds.begin(), worlds.end());
            if (first.empty()) first = state;
            EXPECT_TRUE(state == first);
        });
}

// With forces of the last step, a world at rest is nearly solved before the first sweep; without, it is the same for a world made
// anew.
TEST_F(FastQuickStep, GoesOnWithTheSameBitsFromASavedStateWithoutWarmStart) {
    for (const bool isWarm : {false, true}) {
        Yard yard("fast", isWarm), copy("fast", isWarm);
        yard.step(60);
        yard.copyTo(copy);
        yard.copyTo(yard);  // so that its contacts come in the same order, too
        yard.step();
        copy.step();
        EXPECT_EQ(yard.state() == copy.state(), !isWarm);
    }
}

// A body that is made where one was destroyed is another body: it begins with no forces.
TEST_F(FastQuickStep, KnowsBodiesApartThatHaveOneAddress) {
    dMass mass;
    dMassSetBoxTotal(&mass, 1, 1, 1, 1);
    std::vector<dReal> speeds;
    for (const bool isDestroyed : {false, true}) {
        const dWorldID world = dWorldCreate();
        dODE_MT_SetSolver(world, "fast");
        dWorldSetGravity(world, 0, 0, -10);
        dWorldSetQuickStepNumIterations(world, 0);
        dBodyID body = dBodyCreate(world);
        const dJointGroupID group = dJointGroupCreate(0);
        for (int i = 0; i < 2; ++i) {
            if (i == 1 && isDestroyed) {
                const dBodyID old = body;
                dBodyDestroy(body);
                body = dBodyCreate(world);
                EXPECT_EQ(body, old);  // else this test shows nothing
            }
            dBodySetMass(body, &mass);
            dBodySetPosition(body, 0, 0, 0);
            dBodySetLinearVel(body, 0, 0, 0);
            dWorldSetQuickStepNumIterations(world, i == 0 ? 20 : 0);
            dContact contact = {};
            contact.geom.normal[2] = 1;
            contact.geom.pos[2] = dReal(-0.5);
            dJointAttach(dJointCreateContact(world, group, &contact), body, nullptr);
            dWorldQuickStep(world, kStepSize);
            dJointGroupEmpty(group);
        }
        speeds.push_back(dBodyGetLinearVel(body)[2]);
        dJointGroupDestroy(group);
        dWorldDestroy(world);
    }
    EXPECT_NEAR(speeds[1], -0.1, 1e-6);               // nothing holds it
    EXPECT_GT(speeds[0], dReal(-0.1) + dReal(0.05));  // the last step's force does
}

TEST_F(FastQuickStep, DrawsNoRandomNumbers) {
    Yard yard("fast");
    dRandSetSeed(7);
    yard.step(30);
    EXPECT_EQ(dRandGetSeed(), 7u);
}

TEST_F(FastQuickStep, LetsStacksStand) {
    Yard yard("fast");
    yard.step(300);
    EXPECT_LT(yard.energyOfStacks(), 200 * 2e-3);
    for (int i = 0; i < 200; ++i)
        EXPECT_NEAR(dBodyGetPosition(yard.body(450 + static_cast<std::size_t>(i)))[2], 0.5 + i % 5, 0.02);
}

// A moved-callback attaches a joint to a body that is still to be stepped.
TEST_F(FastQuickStep, StepsIslandsThatChangeDuringTheStep) {
    Yard yard("fast");
    yard.step(30);
    static dBodyID last;
    last = yard.body(0);
    dBodySetMovedCallback(yard.body(500), [](dBodyID body) {
        const dJointID joint = dJointCreateBall(dBodyGetWorld(body), nullptr);
        dJointAttach(joint, last, nullptr);
        dBodySetMovedCallback(body, nullptr);
    });
    yard.step(5);
    for (int i = 0; i < 650; ++i)
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_TRUE(std::isfinite(dBodyGetPosition(yard.body(static_cast<std::size_t>(i)))[axis]));
}

// Memory that a step leaves by a jump is there for the next one.
TEST_F(FastQuickStep, EndsWorldsAndTheLibraryWithNothingKept) {
    for (int i = 0; i < 3; ++i) {
        Yard yard("fast");
        yard.step(3);
    }
    SUCCEED();
}

dBodyID pushed = nullptr;

// Islands that are solved together otherwise are solved one by one: the second body's has yet to be stepped when it is pushed.
TEST_F(FastQuickStep, AForceFromAMovedCallbackActsInTheSameStep) {
    for (const bool isFirst : {true, false}) {
        const dWorldID world = dWorldCreate();
        dODE_MT_SetSolver(world, "fast");
        const dBodyID earlier = dBodyCreate(world), later = dBodyCreate(world);  // upstream begins with the one made last
        pushed = isFirst ? earlier : later;
        dBodySetMovedCallback(isFirst ? later : earlier, [](dBodyID) { dBodyAddForce(pushed, 1000, 0, 0); });
        dWorldQuickStep(world, kStepSize);
        EXPECT_EQ(dBodyGetLinearVel(pushed)[0], isFirst ? 10 : 0);
        EXPECT_EQ(dBodyGetForce(pushed)[0], isFirst ? 0 : 1000);
        dWorldDestroy(world);
    }
}

// Boxes over one another whose contacts do not depend on collision: the same in every world that is in the same state.
class Tower {
public:
    Tower(dWorldID world, dJointGroupID contacts, int boxes, dReal x) : m_world(world), m_contacts(contacts), m_x(x) {
        for (int i = 0; i < boxes; ++i) {
            m_bodies.push_back(dBodyCreate(world));
            dMass mass;
            dMassSetBoxTotal(&mass, 1, 1, 1, 1);
            dBodySetMass(m_bodies.back(), &mass);
        }
        setBack();
    }

    void setBack() {
        for (std::size_t i = 0; i < m_bodies.size(); ++i) {
            const dQuaternion upright = {1, 0, 0, 0};
            dBodySetPosition(m_bodies[i], m_x, 0, dReal(0.5) + dReal(0.999) * dReal(i));
            dBodySetQuaternion(m_bodies[i], upright);
            dBodySetLinearVel(m_bodies[i], 0, 0, 0);
            dBodySetAngularVel(m_bodies[i], 0, 0, 0);
        }
    }

    void touch() const {
        for (std::size_t i = 0; i < m_bodies.size(); ++i)
            for (int corner = 0; corner < 4; ++corner) {
                const dReal *const at = dBodyGetPosition(m_bodies[i]);
                dContact contact = {};
                contact.surface.mode = dContactApprox1;
                contact.surface.mu = dReal(0.5);
                contact.geom.normal[2] = 1;
                contact.geom.depth = dReal(0.001);
                contact.geom.pos[0] = at[0] + ((corner & 1) != 0 ? dReal(0.5) : dReal(-0.5));
                contact.geom.pos[1] = at[1] + ((corner & 2) != 0 ? dReal(0.5) : dReal(-0.5));
                contact.geom.pos[2] = at[2] - dReal(0.5);
                dJointAttach(dJointCreateContact(m_world, m_contacts, &contact), m_bodies[i], i == 0 ? nullptr : m_bodies[i - 1]);
            }
    }

    dBodyID top() const { return m_bodies.back(); }

    std::vector<dReal> velocities() const { return velocitiesOf(m_bodies); }

private:
    dWorldID m_world;
    dJointGroupID m_contacts;
    dReal m_x;
    std::vector<dBodyID> m_bodies;
};

// Two towers, which are solved together.
class Towers {
public:
    Towers(int firstBoxes, int secondBoxes)
        : m_world(dWorldCreate()),
          m_contacts(dJointGroupCreate(0)),
          first(m_world, m_contacts, firstBoxes, 0),
          second(m_world, m_contacts, secondBoxes, 5) {
        dODE_MT_SetSolver(m_world, "fast");
        dWorldSetGravity(m_world, 0, 0, -10);
    }
    ~Towers() {
        dJointGroupDestroy(m_contacts);
        dWorldDestroy(m_world);
    }
    Towers(const Towers &) = delete;
    Towers &operator=(const Towers &) = delete;

    void step(int count = 1) {
        for (int i = 0; i < count; ++i) {
            first.touch();
            second.touch();
            dWorldQuickStep(m_world, kStepSize);
            dJointGroupEmpty(m_contacts);
        }
    }

    dWorldID world() const { return m_world; }
    dJointGroupID contacts() const { return m_contacts; }

private:
    dWorldID m_world;
    dJointGroupID m_contacts;

public:
    Tower first, second;
};

// After a blow to the first tower, both are set back.
void setBackAfterBlow(Towers &towers) {
    towers.step(40);
    dBodySetLinearVel(towers.first.top(), 0, 0, -100);
    towers.step();
    towers.first.setBack();
    towers.second.setBack();
    towers.step();
}

// The forces of a blow are of no use after it. In lanes, and as rows. (Two towers of one group have the end of over-relaxation in common.)
TEST_F(FastQuickStep, ATowerThatIsSetBackStartsWithoutForces) {
    for (const int boxes : {1, 10}) {
        Towers fresh(boxes, 0), used(boxes, 0);
        fresh.step();
        setBackAfterBlow(used);
        EXPECT_EQ(used.first.velocities(), fresh.first.velocities());
    }
}

TEST_F(FastQuickStep, AnotherTowerKeepsItsForces) {
    std::vector<std::vector<dReal>> after;
    for (const bool isWarm : {true, false}) {
        Towers towers(10, 10);
        dODE_MT_SetWarmStart(towers.world(), isWarm);
        setBackAfterBlow(towers);
        after.push_back(towers.second.velocities());
    }
    EXPECT_NE(after[0], after[1]);
}

// Ten boxes on four contacts each, which become lanes. With one feedback structure for all contacts of a box, or one for each contact.
constexpr std::size_t kBoxes = 10, kCorners = 4;
std::array<dJointFeedback, kBoxes * kCorners> feedbackOf(const char *solver, bool isShared) {
    std::array<dJointFeedback, kBoxes * kCorners> feedback{};
    const dWorldID world = dWorldCreate();
    dODE_MT_SetSolver(world, solver);
    dWorldSetGravity(world, 0, 0, -10);
    for (std::size_t i = 0; i < kBoxes; ++i) {
        const dBodyID box = dBodyCreate(world);
        dBodySetPosition(box, dReal(0.3) * dReal(i), 0, 0);
        for (std::size_t corner = 0; corner < kCorners; ++corner) {
            dContact contact = {};
            contact.geom.normal[2] = 1;
            contact.geom.depth = dReal(0.001) * dReal(corner + 1);
            contact.geom.pos[0] = dReal(0.3) * dReal(i) + ((corner & 1) != 0 ? dReal(0.5) : dReal(-0.5));
            contact.geom.pos[1] = (corner & 2) != 0 ? dReal(0.5) : dReal(-0.5);
            const dJointID joint = dJointCreateContact(world, nullptr, &contact);
            dJointAttach(joint, box, nullptr);
            dJointSetFeedback(joint, &feedback[kCorners * i + (isShared ? 0 : corner)]);
        }
    }
    dRandSetSeed(1);  // exact draws numbers
    dWorldQuickStep(world, kStepSize);
    dWorldDestroy(world);
    return feedback;
}

// Whose force the structure that a box's contacts share has.
std::vector<std::size_t> lastWriters(const char *solver) {
    const auto own = feedbackOf(solver, false), shared = feedbackOf(solver, true);
    std::vector<std::size_t> corners;
    for (std::size_t i = 0; i < kBoxes; ++i)
        for (std::size_t corner = 0; corner < kCorners; ++corner)
            if (shared[kCorners * i].f1[2] == own[kCorners * i + corner].f1[2]) corners.push_back(corner);
    return corners;
}

// Joints that share a feedback structure write it in their order, in whatever order contacts are solved.
TEST_F(FastQuickStep, ASharedFeedbackIsThatOfTheLastJoint) {
    const std::vector<std::size_t> expected = lastWriters("exact");
    EXPECT_EQ(expected, std::vector<std::size_t>(kBoxes, expected.at(0)));
    EXPECT_EQ(lastWriters("fast"), expected);
}

// Contacts as rows begin with the last step's forces, too.
TEST_F(FastQuickStep, ContactsAsRowsStartWarm) {
    std::vector<std::vector<dReal>> after;
    for (const bool isWarm : {true, false}) {
        Towers towers(1, 1);
        dODE_MT_SetWarmStart(towers.world(), isWarm);
        towers.step(3);
        towers.first.setBack();
        towers.step();
        after.push_back(towers.first.velocities());
    }
    EXPECT_NE(after[0], after[1]);
}

// However much energy another island of the group has, which is solved at once.
TEST_F(FastQuickStep, AnIslandIsSolvedToItsOwnTolerance) {
    std::vector<std::vector<dReal>> after;
    for (const dReal blow : {dReal(0), dReal(-1e6)}) {
        Towers towers(10, 1);
        std::deque<Tower> others;  // that fill lanes
        for (int i = 2; i < 8; ++i) others.emplace_back(towers.world(), towers.contacts(), 10, 5 * i);
        dODE_MT_SetSolverTolerance(towers.world(), 1e-3);
        dBodySetLinearVel(towers.second.top(), 0, 0, blow);
        for (Tower &other : others) other.touch();
        towers.step();
        after.push_back(towers.first.velocities());
    }
    EXPECT_EQ(after[0], after[1]);
}

// Upstream multiplies infinity with no force, and finds no limit.
TEST_F(FastQuickStep, InfiniteFrictionHoldsWithoutPressure) {
    for (const char *const solver : {"exact", "fast"}) {
        const dWorldID world = dWorldCreate();
        dODE_MT_SetSolver(world, solver);
        dWorldSetQuickStepNumIterations(world, 100);
        for (int i = 0; i < 8; ++i) {  // as many as lanes
            const dBodyID body = dBodyCreate(world);
            dBodySetLinearVel(body, 1, 0, 1);
            dContact contact = {};
            contact.surface.mode = dContactApprox1;
            contact.surface.mu = dInfinity;
            contact.geom.normal[2] = 1;
            dJointAttach(dJointCreateContact(world, nullptr, &contact), body, nullptr);
        }
        dWorldQuickStep(world, kStepSize);
        for (const dxBody *body = world->firstbody; body != nullptr; body = static_cast<const dxBody *>(body->next)) {
            EXPECT_NEAR(body->lvel[0], 0, 1e-6) << solver;
            EXPECT_NEAR(body->lvel[2], 1, 1e-6) << solver;
        }
        dWorldDestroy(world);
    }
}

// Bodies with contacts on all sides and much friction: what over-relaxed sweeps may make grow without end.
std::vector<dReal> clusterAfterStep(const char *solver, unsigned seed, int bodies, int contacts, dReal friction) {
    std::mt19937 random(seed);
    const auto number = [&random](double low, double high) {
        return dReal(low + (high - low) * (static_cast<double>(random()) / 4294967296.0));
    };
    const dWorldID world = dWorldCreate();
    dODE_MT_SetSolver(world, solver);
    dWorldSetGravity(world, 0, 0, -10);
    dWorldSetQuickStepNumIterations(world, 100);
    std::vector<dBodyID> all;
    for (int i = 0; i < bodies; ++i) {
        all.push_back(dBodyCreate(world));
        dMass mass;
        dMassSetBoxTotal(&mass, 1, 1, 1, 1);
        dBodySetMass(all.back(), &mass);
        dBodySetPosition(all.back(), number(-0.7, 0.7), number(-0.7, 0.7), number(-0.7, 0.7));
    }
    for (int i = 0; i < contacts; ++i) {
        const auto first = static_cast<std::size_t>(random() % static_cast<unsigned>(bodies)),
                   second = static_cast<std::size_t>(random() % static_cast<unsigned>(bodies + 1));
        const bool isOfTwo = second < all.size() && second != first;
        dVector3 normal, arm;
        for (int axis = 0; axis < 3; ++axis) {
            arm[axis] = number(-0.6, 0.6);
            normal[axis] = isOfTwo ? dBodyGetPosition(all[first])[axis] - dBodyGetPosition(all[second])[axis] : number(-1, 1);
        }
        dNormalize3(normal);
        dContact contact = {};
        contact.surface.mode = dContactApprox1 | dContactSoftCFM;
        contact.surface.soft_cfm = dReal(1e-5);
        contact.surface.mu = friction;
        contact.geom.depth = dReal(0.005);
        for (int axis = 0; axis < 3; ++axis) {
            contact.geom.pos[axis] = dBodyGetPosition(all[first])[axis] + arm[axis];
            contact.geom.normal[axis] = normal[axis];
        }
        dJointAttach(dJointCreateContact(world, nullptr, &contact), all[first], isOfTwo ? all[second] : nullptr);
    }
    dWorldQuickStep(world, kStepSize);
    std::vector<dReal> speeds;
    for (const dBodyID body : all)
        for (int axis = 0; axis < 3; ++axis) speeds.push_back(std::fabs(dBodyGetLinearVel(body)[axis]));
    dWorldDestroy(world);
    return speeds;
}

TEST_F(FastQuickStep, SweepsOfMuchFrictionDoNotGrow) {
    for (unsigned seed = 0; seed < 1000; ++seed) {
        const std::vector<dReal> fast = clusterAfterStep("fast", seed, 8, 50, 20), exact = clusterAfterStep("exact", seed, 8, 50, 20);
        const dReal usual = *std::max_element(exact.begin(), exact.end());
        for (const dReal speed : fast) ASSERT_LT(speed, 100 * (usual + 1)) << "seed " << seed;
    }
}

// Unequal masses on stiff joints that few iterations do not solve: what a step has not found, the next one corrects. Forces kept from
// step to step, or an order that stays the same, would make that grow.
TEST_F(FastQuickStep, StiffJointsDoNotRunAway) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        std::mt19937 random(seed);
        const dWorldID world = dWorldCreate();
        dODE_MT_SetSolver(world, "fast");
        dWorldSetERP(world, dReal(0.8));
        dWorldSetCFM(world, 0);
        std::vector<dBodyID> bodies;
        for (unsigned i = 0; i < 8; ++i) {
            bodies.push_back(dBodyCreate(world));
            dMass mass;
            dMassSetBoxTotal(&mass, i % 2 == 0 ? 1 : 50, 1, 1, 1);
            dBodySetMass(bodies.back(), &mass);
            const dReal *const before = i == 0 ? nullptr : dBodyGetPosition(bodies[random() % i]);
            if (before == nullptr) continue;
            const unsigned axis = random() % 3;
            dBodySetPosition(bodies[i], before[0] + (axis == 0), before[1] + (axis == 1), before[2] + (axis == 2));
            for (unsigned k = 0; k < i; ++k)
                if (dBodyGetPosition(bodies[k]) == before) {
                    const dJointID joint = dJointCreateFixed(world, nullptr);
                    dJointAttach(joint, bodies[i], bodies[k]);
                    dJointSetFixed(joint);
                }
        }
        dBodySetAngularVel(bodies[0], 1, 1, 0);
        for (int i = 0; i < 300; ++i) dWorldQuickStep(world, kStepSize);
        for (const dBodyID body : bodies)
            for (int axis = 0; axis < 3; ++axis)
                ASSERT_LT(std::fabs(dBodyGetLinearVel(body)[axis]), 5) << "seed " << seed;
        dWorldDestroy(world);
    }
}

}  // namespace
