// Islands whose exact step several workers take together: hundreds of rows in the LCP, in changing numbers.
#include "additions.h"
#include "joint_lattice.h"
#include "packed_stack.h"

#include <cmath>
#include <string>
#include <utility>

namespace exactness {

namespace {

constexpr int kColumns = 3, kRows = 3, kLayers = 2;

class Stack : public PackedStack {
public:
    explicit Stack(Stepper stepper) : PackedStack(stepper, kColumns, kRows, kLayers) {}
};

// Masses over four decades, hardly any softness, friction that is unlimited or a pyramid of the normal's force.
class UnevenStack : public Stack {
public:
    explicit UnevenStack(Stepper stepper) : Stack(stepper) {
        for (const dBodyID brick : bricks()) setMass(brick, std::pow(dReal(10), m_dice.between(-2, 2)));
        dWorldSetCFM(world(), dReal(1e-10));
    }

protected:
    void setSurface(dContact &contact) override {
        PackedStack::setSurface(contact);
        contact.surface.mode = m_dice.oneIn(2) ? dContactApprox1 : 0;
        contact.surface.mu = m_dice.oneIn(3) ? dInfinity : dReal(0.4);
    }
};

// More contacts than bodies have freedoms, and hardly anything soft. (Without softness libode8 ends the program.)
class SingularStack : public Stack {
public:
    explicit SingularStack(Stepper stepper) : Stack(stepper) {
        dWorldSetCFM(world(), dReal(1e-13));
        m_surface.mode = 0;
        m_surface.mu = dInfinity;
        m_contactLimit = 8;
    }
};

// Pairs lose their contacts and get them back, and the stack is shaken.
class FlickeringStack : public Stack {
public:
    using Stack::Stack;

    void control() override {
        Stack::control();
        for (const dBodyID brick : bricks())
            dBodyAddForce(brick, m_dice.between(-20, 20), m_dice.between(-20, 20), m_dice.between(-20, 20));
    }

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        if (!m_dice.oneIn(4)) Stack::onNearPair(o1, o2);
    }
};

// A heap that is pushed against its own weight: rows of friction slide, stick and slide again.
class PushedStack : public Stack {
public:
    explicit PushedStack(Stepper stepper) : Stack(stepper) {
        m_surface.mode = dContactApprox1;
        m_surface.mu = dReal(0.5);
    }

    void control() override {
        Stack::control();
        const dReal push = frameNumber() % 2 == 0 ? 400 : -300;
        for (std::size_t i = 0; i < bricks().size(); i += kColumns) dBodyAddForce(bricks()[i], push, 10, 0);
    }
};

// Hinges with motors that reach their stops: rows without limits, with wide ones and with narrow ones.
class PoweredLattice : public JointLattice {
public:
    explicit PoweredLattice(Stepper stepper) : JointLattice(stepper, 7) { build(); }

    void control() override {
        for (const dJointID joint : m_inventory.joints)
            if (dJointGetType(joint) == dJointTypeHinge) dJointSetHingeParam(joint, dParamVel, m_dice.between(-4, 4));
    }

protected:
    void join(int number, dBodyID first, dBodyID second, Vector3 anchor) override {
        if (number % 3 == 0) {
            addBall(first, second, anchor);
            return;
        }
        const dJointID hinge = addHinge(first, second, anchor, number % 2 == 0 ? scenes::kAxisX : scenes::kAxisY);
        dJointSetHingeParam(hinge, dParamFMax, m_dice.between(0.1, 5));
        dJointSetHingeParam(hinge, dParamLoStop, -0.02);
        dJointSetHingeParam(hinge, dParamHiStop, 0.03);
    }
};

// The large island beside small ones, which are too few to be worth anybody's time.
class StackAndCrumbs : public Stack {
public:
    explicit StackAndCrumbs(Stepper stepper) : Stack(stepper) {
        for (int i = 0; i < 8; ++i) addBox({dReal(i), 20, 0.24}, {kEdge, kEdge, kEdge}, 1);
    }
};

}  // namespace

void addLargeExactIslands(Catalogue &catalogue) {
    const auto add = [&](const char *name, const char *meaning, Scenario::Make make) {
        catalogue.push_back(
            teamScenario(std::string("large_exact_islands/") + name, meaning, 5, std::move(make), Stepper::World));
    };
    add("stack", "boxes packed closely on the ground", make<Stack>());
    add("uneven", "masses over four decades, hardly any softness, unlimited and pyramidal friction", make<UnevenStack>());
    add("singular", "more contacts than freedoms, hardly any softness, unlimited friction", make<SingularStack>());
    add("flickering", "contacts that appear and disappear", make<FlickeringStack>());
    add("pushed", "friction that slides and sticks", make<PushedStack>());
    add("powered", "a lattice of hinges with motors and stops", make<PoweredLattice>());
    add("crumbs", "a stack and a few small islands", make<StackAndCrumbs>());
}

}  // namespace exactness
