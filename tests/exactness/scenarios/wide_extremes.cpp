// One island that several workers step together, at the ends of what numbers hold: no softness, redundant
// joints, masses and inertias apart by many decades, numbers too small and too large.
#include "additions.h"
#include "joint_lattice.h"
#include "packed_stack.h"

#include <limits>
#include <string>
#include <utility>

namespace exactness {

namespace {

// Alternating layers of 1 mg and of 1000 kg, the heavy ones above, without softness and with unlimited friction.
class MassRatio : public PackedStack {
public:
    explicit MassRatio(Stepper stepper) : PackedStack(stepper, 6, 6, 4) {
        constexpr std::size_t bricksOfLayer = 36;
        for (std::size_t i = 0; i < bricks().size(); ++i)
            setMass(bricks()[i], i / bricksOfLayer % 2 == 0 ? 1e-6 : 1e3);
        m_surface.mode = dContactApprox1;
        m_surface.mu = dInfinity;
        dWorldSetCFM(world(), 0);
    }
};

// More sweeps than usual, over-relaxed, of rows without softness.
class ManySweeps : public PackedStack {
public:
    explicit ManySweeps(Stepper stepper) : PackedStack(stepper, 6, 6, 3) {
        m_surface.mode = 0;
        dWorldSetCFM(world(), 0);
        dWorldSetQuickStepNumIterations(world(), 33);
        dWorldSetQuickStepW(world(), 1.9);
    }
};

// Neighbours joined more than once, so that many rows depend on others; softness zero, or as good as.
class Redundant : public JointLattice {
public:
    Redundant(Stepper stepper, dReal softness) : JointLattice(stepper, 14) {
        dWorldSetCFM(world(), softness);
        build();
        for (const dBodyID knot : knots()) dBodySetAngularVel(knot, 1, m_dice.between(-1, 1), 0);
    }

protected:
    void join(int number, dBodyID first, dBodyID second, Vector3 anchor) override {
        addHinge(first, second, anchor, scenes::kAxisZ);
        if (number % 2 == 0) addHinge(second, first, anchor, scenes::kAxisZ);
        if (number % 3 == 0) addFixed(first, second);
    }
};

// Rods whose moments of inertia differ by eight decades, thrown about on long levers.
class Rods : public JointLattice {
public:
    explicit Rods(Stepper stepper) : JointLattice(stepper) {
        dWorldSetCFM(world(), 0);
        build();
        for (const dBodyID knot : knots()) {
            dMass rod;
            dMassSetParameters(&rod, m_dice.between(0.1, 10), 0, 0, 0, 1e4, 1e4, 1e-4, 0, 0, 0);
            dBodySetMass(knot, &rod);
            dBodySetAngularVel(knot, m_dice.between(-3, 3), 0, m_dice.between(-300, 300));
        }
    }

protected:
    void join(int, dBodyID first, dBodyID second, Vector3 anchor) override { addBall(first, second, anchor); }
};

// Contacts without a direction: all of the row is zero, and softness is all that is left to divide by.
class ZeroRows : public PackedStack {
public:
    explicit ZeroRows(Stepper stepper) : PackedStack(stepper, 7, 7, 3) {
        m_surface.mode = dContactSoftCFM;
        m_surface.soft_cfm = 1e-10;
    }

protected:
    void setSurface(dContact &contact) override {
        PackedStack::setSurface(contact);
        if (!m_dice.oneIn(15)) return;
        contact.surface.mu = 0;  // friction would need a direction
        for (int i = 0; i < 3; ++i) contact.geom.normal[i] = 0;
    }
};

// Bodies that nothing can move, in twos: joints between them have no rows.
class Immovable : public JointLattice {
public:
    explicit Immovable(Stepper stepper) : JointLattice(stepper, 20) {
        dWorldSetCFM(world(), 0);
        build();
        for (std::size_t i = 0; i < knots().size(); ++i)
            if (i % 13 < 2) dBodySetKinematic(knots()[i]);
    }

    void control() override {
        for (std::size_t i = 0; i < knots().size(); i += 13)
            dBodySetLinearVel(knots()[i], 0, 0, m_dice.between(-1, 1));
    }

protected:
    void join(int, dBodyID first, dBodyID second, Vector3 anchor) override { addBall(first, second, anchor); }
};

// Speeds of the order of `size`: so small that what is computed of them is denormal, or so large that it
// nearly overflows.
class Speeds : public JointLattice {
public:
    Speeds(Stepper stepper, dReal size) : JointLattice(stepper) {
        dWorldSetGravity(world(), 0, 0, 0);
        build();
        for (const dBodyID knot : knots()) {
            const Vector3 speed = size * m_dice.within(1);
            dBodySetLinearVel(knot, speed.x, speed.y, speed.z);
            dBodySetAngularVel(knot, speed.z, speed.x, speed.y);
            dBodySetGyroscopicMode(knot, 0);
        }
    }

protected:
    void join(int, dBodyID first, dBodyID second, Vector3 anchor) override { addBall(first, second, anchor); }
};

}  // namespace

void addWideExtremes(Catalogue &catalogue) {
    const auto add = [&](const char *name, const char *meaning, Scenario::Make make) {
        catalogue.push_back(teamScenario(std::string("wide_extremes/") + name, meaning, 10, std::move(make)));
    };
    add("mass_ratio", "masses apart by nine decades, no softness, unlimited friction", make<MassRatio>());
    add("many_sweeps", "33 sweeps, over-relaxed, no softness", make<ManySweeps>());
    add("redundant", "neighbours joined several times, no softness", make<Redundant>(dReal(0)));
    add("nearly_redundant", "the same with hardly any softness", make<Redundant>(dReal(1e-15)));
    add("rods", "moments of inertia apart by eight decades, no softness", make<Rods>());
    add("zero_rows", "contacts without a direction, hardly any softness", make<ZeroRows>());
    add("immovable", "kinematic bodies joined to one another and to others, no softness", make<Immovable>());
    add("denormal", "speeds about the smallest number", make<Speeds>(16 * std::numeric_limits<dReal>::min()));
    add("huge", "speeds whose squares are near the largest number", make<Speeds>(dReal(1e100)));
}

}  // namespace exactness
