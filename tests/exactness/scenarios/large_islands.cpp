// Islands so large that several workers step them together: rows of contacts and of joints in every mixture.
#include "additions.h"
#include "packed_stack.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace exactness {

namespace {

// Varies the number of sweeps around those at which upstream shuffles; other relaxation.
class StackOfManySweeps : public PackedStack {
public:
    using PackedStack::PackedStack;

    void control() override {
        PackedStack::control();
        constexpr int sweeps[] = {20, 9, 8, 1, 16, 17, 25, 10};
        const int turn = frameNumber() % 8;
        dWorldSetQuickStepNumIterations(world(), sweeps[turn]);
        dWorldSetQuickStepW(world(), turn < 4 ? dReal(1.3) : dReal(0.9));
    }
};

// Masses over six decades, no softness, unlimited friction, some bodies that nothing can move.
class UnevenStack : public PackedStack {
public:
    explicit UnevenStack(Stepper stepper) : PackedStack(stepper) {
        for (const dBodyID brick : bricks()) {
            setMass(brick, std::pow(dReal(10), m_dice.between(-3, 3)));
            if (m_dice.oneIn(20)) dBodySetKinematic(brick);
        }
        m_surface.mode = 0;
        m_surface.mu = dInfinity;
        dWorldSetCFM(world(), 0);
    }
};

// Joints of every kind between neighbours, motors among them, which push their bodies while rows are read.
class JointedStack : public PackedStack {
public:
    explicit JointedStack(Stepper stepper) : PackedStack(stepper) {
        for (std::size_t i = 1; i < bricks().size(); i += 3) joinByTurns(bricks()[i - 1], bricks()[i]);
    }

private:
    void joinByTurns(dBodyID first, dBodyID second) {
        const dReal *const at = dBodyGetPosition(second);
        const Vector3 anchor{at[0] - kEdge / 2, at[1], at[2]};
        switch (m_dice.below(3)) {
            case 0:
                addBall(first, second, anchor);
                break;
            case 1: {
                const dJointID hinge = addHinge(first, second, anchor, scenes::kAxisY);
                dJointSetHingeParam(hinge, dParamVel, 1);
                dJointSetHingeParam(hinge, dParamFMax, 20);
                dJointSetHingeParam(hinge, dParamFudgeFactor, 0.5);
                dJointSetHingeParam(hinge, dParamLoStop, -0.01);
                dJointSetHingeParam(hinge, dParamHiStop, 0.01);
                break;
            }
            default:
                addFeedback(addBall(first, second, anchor));
        }
    }
};

// Contacts of some pairs report their forces.
class ReportingStack : public PackedStack {
public:
    using PackedStack::PackedStack;

    void step() override {
        PackedStack::step();
        noteContactFeedback();
    }

protected:
    void onContact(dJointID joint) override {
        if (m_dice.oneIn(8)) addContactFeedback(joint);
    }
};

// A net of balls joined to their neighbours, hanging from two corners: joints alone.
class Net : public ScenarioScene {
public:
    explicit Net(Stepper stepper) : ScenarioScene(stepper) {
        constexpr int kMeshes = 24;
        constexpr dReal kPitch = 0.2;  // m
        std::vector<dBodyID> knots;
        for (int y = 0; y < kMeshes; ++y)
            for (int x = 0; x < kMeshes; ++x) {
                const Vector3 place{kPitch * x, kPitch * y, 3};
                knots.push_back(addSphere(place, 0.05, 0.1));
                if (x > 0) addBall(knots[knots.size() - 2], knots.back(), place + Vector3{-kPitch / 2, 0, 0});
                if (y > 0)
                    addBall(knots[knots.size() - 1 - kMeshes], knots.back(), place + Vector3{0, -kPitch / 2, 0});
            }
        addBall(knots.front(), nullptr, {0, 0, 3});
        addBall(knots.back(), nullptr, {kPitch * (kMeshes - 1), kPitch * (kMeshes - 1), 3});
    }
};

// Spokes that all act on one hub, and start from one place: no partition exists, and every part waits for every
// other one.
class Hub : public ScenarioScene {
public:
    explicit Hub(Stepper stepper) : ScenarioScene(stepper), m_dice(5) {
        const dBodyID hub = addBody({0, 0, 5}, world());
        for (int i = 0; i < 700; ++i) {
            const dBodyID spoke = addBody({0, 0, 5}, world());
            const Vector3 anchor = Vector3{0, 0, 5} + m_dice.within(0.3);
            i % 2 == 0 ? addBall(hub, spoke, anchor) : addBall(spoke, hub, anchor);
            dBodySetLinearVel(spoke, m_dice.between(-1, 1), m_dice.between(-1, 1), 0);
        }
    }

private:
    Dice m_dice;
};

// A chain whose bodies are in one line, beside crowds of islands of one body each.
class ChainAndCrowd : public ScenarioScene {
public:
    explicit ChainAndCrowd(Stepper stepper) : ScenarioScene(stepper) {
        addGround();
        constexpr dReal kLink = 0.1;  // m
        dBodyID before = nullptr;
        for (int i = 0; i < 900; ++i) {
            const Vector3 place{kLink * i, 0, 4};
            const dBodyID link = addSphere(place, 0.03, 0.1);
            addBall(link, before, place + Vector3{-kLink / 2, 0, 0});
            before = link;
        }
        for (int i = 0; i < 60; ++i) addBox({dReal(i), 20, 0.24}, {0.5, 0.5, 0.5}, 1);
    }
};

// Two large islands and a change of sizes: bricks are taken away, and come to rest and wake.
class TwoShrinkingStacks : public PackedStack {
public:
    explicit TwoShrinkingStacks(Stepper stepper) : PackedStack(stepper, 8, 8, 3) {
        for (int i = 0; i < 120; ++i)
            addBox({30 + dReal(0.49) * (i % 6), dReal(0.49) * (i / 6 % 5), 0.24 + dReal(0.48) * (i / 30)},
                   {kEdge, kEdge, kEdge}, 1);
        dWorldSetAutoDisableFlag(world(), 1);
        dWorldSetAutoDisableSteps(world(), 6);
    }

    void control() override {
        PackedStack::control();
        if (frameNumber() % 4 == 0) dBodyDisable(bricks()[static_cast<std::size_t>(frameNumber())]);
        if (frameNumber() % 4 == 2) dBodyAddForce(bricks()[static_cast<std::size_t>(frameNumber())], 30, 0, 60);
    }
};

// In some frames a callback hears that a body has moved, and sees which of the others have: the next ones have not.
class ListeningStack : public PackedStack {
public:
    using PackedStack::PackedStack;

    void control() override {
        PackedStack::control();
        const std::size_t last = bricks().size() - 1;
        for (const std::size_t i : {std::size_t{5}, last / 2, last}) {
            if (frameNumber() % 3 == 0) watchMoved(bricks()[i]);
            if (frameNumber() % 3 == 1) dBodySetMovedCallback(bricks()[i], nullptr);
        }
        dBodySetFiniteRotationMode(bricks()[9], frameNumber() % 2);
        dBodySetLinearDamping(bricks()[10], dReal(0.1));
        dBodySetMaxAngularSpeed(bricks()[11], dReal(0.2));
    }

protected:
    void onMoved(dBodyID body) override {
        note("height of the moved body", dBodyGetPosition(body)[2]);
        for (std::size_t i = 0; i < bricks().size(); i += 17) {
            note("height of another body", dBodyGetPosition(bricks()[i])[2]);
            note("velocity of another body", dBodyGetLinearVel(bricks()[i])[2]);
            note("force on another body", dBodyGetForce(bricks()[i])[2]);
        }
    }
};

}  // namespace

void addLargeIslands(Catalogue &catalogue) {
    const auto add = [&](const char *name, const char *meaning, Scenario::Make make) {
        catalogue.push_back(teamScenario(std::string("large_islands/") + name, meaning, 10, std::move(make)));
    };
    add("stack", "boxes packed closely on the ground", make<PackedStack>());
    add("sweeps", "numbers of sweeps around those at which rows are shuffled", make<StackOfManySweeps>());
    add("uneven", "masses over six decades, no softness, unlimited friction, kinematic bodies", make<UnevenStack>());
    add("joints", "motors and joints that report forces among the contacts", make<JointedStack>());
    add("feedback", "contacts that report forces", make<ReportingStack>());
    add("net", "a net of ball joints", make<Net>());
    add("hub", "a body on which all rows act", make<Hub>());
    add("chain", "a chain in one line, and a crowd of small islands", make<ChainAndCrowd>());
    add("listening", "bodies of an island that report that they moved, in some frames", make<ListeningStack>());
    add("shrinking", "two islands whose bodies are put to sleep and wake", make<TwoShrinkingStacks>());
}

}  // namespace exactness
