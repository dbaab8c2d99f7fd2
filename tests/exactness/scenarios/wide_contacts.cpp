// One island of so many contacts that several workers step it together: contacts that come, go and change.
#include "additions.h"
#include "packed_stack.h"

#include <cmath>
#include <string>
#include <utility>

namespace exactness {

namespace {

// Any combination of what a surface can have, another one for each contact.
class AnySurface : public PackedStack {
public:
    explicit AnySurface(Stepper stepper) : PackedStack(stepper, 7, 7, 3) {}

protected:
    void setSurface(dContact &contact) override {
        constexpr int modes[] = {dContactAxisDep,   dContactFDir1,    dContactBounce,  dContactSoftERP,
                                 dContactSoftCFM,   dContactMotion1,  dContactMotion2, dContactMotionN,
                                 dContactSlip1,     dContactSlip2,    dContactRolling, dContactApprox1_1,
                                 dContactApprox1_2, dContactApprox1_N};
        dSurfaceParameters &surface = contact.surface;
        surface.mode = 0;
        for (const int mode : modes) {
            if (m_dice.oneIn(3)) surface.mode |= mode;
        }
        surface.mu = m_dice.oneIn(6) ? dInfinity : m_dice.between(0, 1.5);
        surface.mu2 = m_dice.oneIn(6) ? 0 : m_dice.between(0, 1);
        surface.rho = m_dice.between(0, 0.1);
        surface.rho2 = m_dice.between(0, 0.1);
        surface.rhoN = m_dice.oneIn(4) ? dInfinity : m_dice.between(0, 0.1);
        surface.bounce = m_dice.between(0, 1);
        surface.bounce_vel = m_dice.between(0, 1);
        surface.soft_erp = m_dice.between(0, 0.2);
        surface.soft_cfm = m_dice.oneIn(4) ? 0 : m_dice.between(0, 1e-2);
        surface.motion1 = m_dice.between(-1, 1);
        surface.motion2 = m_dice.between(-1, 1);
        surface.motionN = m_dice.between(-0.02, 0.02);
        surface.slip1 = m_dice.between(0, 0.1);
        surface.slip2 = m_dice.between(0, 0.1);
        dVector3 other;
        dPlaneSpace(contact.geom.normal, contact.fdir1, other);
        contact.fdir1[3] = 0;
    }
};

// Bricks in a wave that runs through every other layer touch nothing; behind it they touch again.
class Waves : public PackedStack {
public:
    explicit Waves(Stepper stepper) : PackedStack(stepper, 7, 7, 3) {}

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        if (!isInCrest(o1) && !isInCrest(o2)) PackedStack::onNearPair(o1, o2);
    }

private:
    bool isInCrest(dGeomID geom) const {
        const dBodyID body = dGeomGetBody(geom);
        if (body == nullptr) return false;
        const dReal *const at = dBodyGetPosition(body);
        const long column = std::lround(at[0] / 0.49), row = std::lround(at[1] / 0.49),
                   layer = std::lround(at[2] / 0.48);
        return (column + row + frameNumber()) % 5 == 0 && (layer + frameNumber()) % 2 == 0;
    }
};

// One to eight contacts for a pair, changing from frame to frame.
class ContactCounts : public PackedStack {
public:
    explicit ContactCounts(Stepper stepper) : PackedStack(stepper, 7, 7, 3) {}

    void control() override {
        constexpr int limits[] = {8, 1, 5, 2, 7, 3};
        m_contactLimit = limits[frameNumber() % 6];
    }
};

// The callback alternately skips so many pairs that the island is large enough for several workers, or is not.
class Threshold : public PackedStack {
public:
    explicit Threshold(Stepper stepper) : PackedStack(stepper, 6, 6, 3) {}

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        constexpr int tenths[] = {10, 5, 4, 3, 6, 2};
        if (m_dice.below(10) < tenths[frameNumber() % 6]) PackedStack::onNearPair(o1, o2);
    }
};

// Two stacks that a beam makes one island of in every other frame.
class Merging : public PackedStack {
public:
    explicit Merging(Stepper stepper) : PackedStack(stepper, 5, 5, 3) {
        for (int i = 0; i < 50; ++i)
            addBox({30 + dReal(0.49) * (i % 5), dReal(0.49) * (i / 5 % 5), 0.24 + dReal(0.48) * (i / 25)},
                   {kEdge, kEdge, kEdge}, 1);
        m_beam = addFixed(m_inventory.bodies.back(), bricks().front());
    }

    void control() override {
        if (frameNumber() % 2 == 0) {
            dJointEnable(m_beam);
        } else {
            dJointDisable(m_beam);
        }
    }

private:
    dJointID m_beam;
};

// Gravity rotates by a right angle and more from frame to frame: bricks separate and touch others.
class Rocking : public PackedStack {
public:
    explicit Rocking(Stepper stepper) : PackedStack(stepper, 7, 7, 3) {}

    void control() override {
        const dReal angle = dReal(1.9) * frameNumber();
        dWorldSetGravity(world(), 60 * std::cos(angle), 60 * std::sin(angle),
                         frameNumber() % 3 == 0 ? 30 : -40);
    }
};

// Parameters of the world and lengths of steps over four decades.
class Parameters : public PackedStack {
public:
    explicit Parameters(Stepper stepper) : PackedStack(stepper, 7, 7, 3) {
        m_surface.mode = dContactApprox1;  // the world's own ERP and CFM
    }

    void control() override {
        const int turn = frameNumber() % 6;
        constexpr dReal lengths[] = {0.01, 0.00001, 0.02, 0.001, 0.005, 0.0001};
        constexpr dReal softness[] = {0, 1e-10, 1e-3, 0, 0.1, 1e-15};
        m_stepSize = lengths[turn];
        dWorldSetCFM(world(), softness[turn]);
        dWorldSetERP(world(), dReal(0.1) * turn);
        dWorldSetContactMaxCorrectingVel(world(), turn % 2 == 0 ? dReal(0.05) : dReal(0.5));
        dWorldSetContactSurfaceLayer(world(), turn % 3 == 0 ? dReal(0.01) : 0);
        dWorldSetQuickStepW(world(), dReal(0.7) + dReal(0.2) * turn);
    }
};

// Rams that nothing can move drive through a stack in which bricks fall asleep and are woken.
class Rams : public PackedStack {
public:
    explicit Rams(Stepper stepper) : PackedStack(stepper, 7, 7, 3) {
        dWorldSetAutoDisableFlag(world(), 1);
        dWorldSetAutoDisableSteps(world(), 3);
        dWorldSetAutoDisableLinearThreshold(world(), 0.2);
        for (int i = 0; i < 3; ++i) {
            const dBodyID ram =
                addBox({-0.5, dReal(1.2) * i + dReal(0.4), dReal(0.3) + dReal(0.5) * i}, {0.6, 0.3, 0.3}, 1);
            dBodySetKinematic(ram);
            dBodySetLinearVel(ram, 6 - 2 * i, 0, 0);
            dBodySetAngularVel(ram, 0, 0, 3 * i);
        }
    }

    void control() override {
        for (std::size_t i = 0; i < bricks().size(); ++i) {
            const dBodyID brick = bricks()[i];
            if ((i + frameNumber()) % 11 == 0) dBodyDisable(brick);
            if ((i + frameNumber()) % 23 == 0) toggle(brick);
        }
    }

private:
    static void toggle(dBodyID brick) {
        if (dBodyIsKinematic(brick)) {
            dBodySetDynamic(brick);
        } else {
            dBodySetKinematic(brick);
        }
    }
};

// The user draws from the sequence that shuffles the rows, and sets its seed.
class Draws : public PackedStack {
public:
    explicit Draws(Stepper stepper) : PackedStack(stepper, 7, 7, 3) { dRandSetSeed(4711); }

    void control() override {
        note("drawn by the user", dRandInt(1000));
        if (frameNumber() == 5) dRandSetSeed(0x89abcdef);
        dWorldSetQuickStepNumIterations(world(), 8 + frameNumber());
    }

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        if (dRandInt(9) != 0) PackedStack::onNearPair(o1, o2);
    }
};

// Bricks, balls, capsules and cylinders in one heap: one to eight contacts for a pair.
class Shapes : public ScenarioScene {
public:
    explicit Shapes(Stepper stepper) : ScenarioScene(stepper) {
        addGround();
        m_contactLimit = kMaxContacts;
        constexpr int side = 7;
        for (int i = 0; i < side * side * 4; ++i)
            addShape(i, {dReal(0.38) * (i % side), dReal(0.38) * (i / side % side),
                         dReal(0.19) + dReal(0.38) * (i / side / side)});
    }

private:
    void addShape(int number, Vector3 place) {
        switch (number % 4) {
            case 0:
                addBox(place, {0.42, 0.42, 0.42}, 1);
                break;
            case 1:
                addSphere(place, 0.21, 2);
                break;
            case 2:
                addCapsule(place, scenes::kAxisY, 0.18, 0.1, 1);
                break;
            default:
                addCylinder(place, scenes::kAxisX, 0.2, 0.42, 1);
        }
    }
};

// Every way of integrating a body, side by side in one stack of spinning bricks under the user's forces.
class MotionModes : public PackedStack {
public:
    explicit MotionModes(Stepper stepper) : PackedStack(stepper, 7, 7, 3) {
        dWorldSetLinearDampingThreshold(world(), 0.1);
        dWorldSetAngularDampingThreshold(world(), 0.1);
        for (const dBodyID brick : bricks()) {
            const Vector3 spin = m_dice.within(20);
            dBodySetAngularVel(brick, spin.x, spin.y, spin.z);
            dBodySetGyroscopicMode(brick, m_dice.below(2));
            dBodySetGravityMode(brick, m_dice.oneIn(5) ? 0 : 1);
            if (m_dice.oneIn(2)) dBodySetFiniteRotationMode(brick, 1);
            if (m_dice.oneIn(4)) dBodySetFiniteRotationAxis(brick, spin.x, spin.y, 1);
            if (m_dice.oneIn(3)) dBodySetDamping(brick, 0.02, 0.05);
            if (m_dice.oneIn(3)) dBodySetMaxAngularSpeed(brick, 8);
        }
    }

    void control() override {
        for (const dBodyID brick : bricks()) {
            if (m_dice.oneIn(3)) dBodyAddForceAtRelPos(brick, 20, 0, 5, 0, 0.1, 0.2);
            if (m_dice.oneIn(3)) dBodyAddRelTorque(brick, 0, 3, 1);
        }
    }
};

}  // namespace

void addWideContacts(Catalogue &catalogue) {
    const auto add = [&](const char *name, const char *meaning, Scenario::Make make) {
        catalogue.push_back(teamScenario(std::string("wide_contacts/") + name, meaning, 10, std::move(make)));
    };
    add("any_surface", "any combination of modes of contacts, side by side", make<AnySurface>());
    add("waves", "contacts that vanish and come back in waves", make<Waves>());
    add("contact_counts", "one to eight contacts for a pair, another number in each frame",
        make<ContactCounts>());
    add("threshold", "an island that is alternately large enough for several workers and too small", make<Threshold>());
    add("merging", "two stacks that are one island in every other frame", make<Merging>());
    add("rocking", "gravity that turns from frame to frame", make<Rocking>());
    add("parameters", "lengths of steps, softness and correction over decades", make<Parameters>());
    add("rams", "kinematic rams through bricks that fall asleep, bricks kinematic for a while", make<Rams>());
    add("draws", "draws of the user between the shuffles", make<Draws>());
    add("shapes", "a heap of all shapes", make<Shapes>());
    add("motion_modes", "finite rotation, gyroscopic force, damping, speed limits, user forces",
        make<MotionModes>());
}

}  // namespace exactness
