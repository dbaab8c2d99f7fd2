// Islands whose rows depend on one another, so that the exact step's matrix is singular, or as good as:
// redundant joints, too many contacts, masses apart by many decades, no softness to speak of.
#include "additions.h"
#include "dice.h"
#include "scenario_scene.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace exactness {

namespace {

constexpr dReal noSoftness = 0;
constexpr dReal stickyForce = 1e6;          // N: a limit, as rows without one would have no solution
constexpr dReal hardlyAnySoftness = 1e-15;  // less than what the rounding of a diagonal element leaves

// Rings of hinges about parallel axes, hanging from one link: three rows of each ring are redundant.
class ClosedLoops : public ManyParts {
public:
    ClosedLoops(Stepper stepper, dReal softness) : ManyParts(stepper) {
        dWorldSetCFM(world(), softness);
        addParts([this](int part, Vector3 origin) { addRing(3 + part % 8, origin + Vector3{0, 0, 3}); });
    }

private:
    void addRing(int links, Vector3 centre) {
        const auto at = [=](dReal link) {
            const dReal angle = 2 * dReal(M_PI) * link / links;
            return centre + Vector3{std::cos(angle), 0, std::sin(angle)};
        };
        std::vector<dBodyID> ring;
        for (int i = 0; i < links; ++i) ring.push_back(addBody(at(i), world()));
        for (int i = 0; i < links; ++i)
            addFeedback(addHinge(ring[i], ring[(i + 1) % links], at(i + dReal(0.5)), scenes::kAxisY));
        addBall(ring.front(), nullptr, at(0));
        dBodySetLinearVel(ring.back(), 1, 0.5, 0);
    }
};

// Chains of bodies joined by two to six joints where one would do.
class Doubled : public ManyParts {
public:
    explicit Doubled(Stepper stepper) : ManyParts(stepper) {
        dWorldSetCFM(world(), hardlyAnySoftness);
        addParts([this](int part, Vector3 origin) {
            dBodyID before = nullptr;
            for (int link = 0; link <= part % 6; ++link) {
                const Vector3 place = origin + Vector3{dReal(0.5) * link, 0, 3};
                const dBodyID body = addBody(place, world());
                for (int i = 0; i < 2; ++i) joinBy(part + link, body, before, place + Vector3{-0.25, 0, 0});
                dBodySetAngularVel(body, 0.5, 1, -0.3 * link);
                before = body;
            }
        });
    }

private:
    void joinBy(int number, dBodyID body, dBodyID before, Vector3 anchor) {
        if (number % 2 == 0) addBall(body, before, anchor);
        if (number % 3 == 0) addHinge(body, before, anchor, scenes::kAxisY);
        if (number % 3 == 1) addFixed(body, before);
    }
};

// Motors that push the same bodies along the same axes to different speeds: rows with limits, equal but for
// these.
class RivalMotors : public ManyParts {
public:
    explicit RivalMotors(Stepper stepper) : ManyParts(stepper), m_dice(41) {
        dWorldSetCFM(world(), noSoftness);
        addParts([this](int part, Vector3 origin) {
            dBodyID before = nullptr;
            for (int link = 0; link <= part % 6; ++link) {
                const dBodyID body = addBody(origin + Vector3{dReal(0.5) * link, 0, 3}, world());
                for (int i = 0; i < 2 + part % 3; ++i) addMotors(body, before);
                before = body;
            }
        });
    }

    void control() override {
        for (const dJointID motor : m_linear) dJointSetLMotorParam(motor, dParamVel2, m_dice.between(-1, 1));
    }

private:
    void addMotors(dBodyID body, dBodyID before) {
        m_linear.push_back(add(dJointCreateLMotor(world(), nullptr)));
        const dJointID linear = m_linear.back(), angular = add(dJointCreateAMotor(world(), nullptr));
        dJointAttach(linear, body, before);
        dJointSetLMotorNumAxes(linear, 3);
        dJointAttach(angular, body, before);
        dJointSetAMotorNumAxes(angular, 3);
        for (int axis = 0; axis < 3; ++axis) {
            dJointSetLMotorAxis(linear, axis, 0, axis == 0, axis == 1, axis == 2);
            dJointSetAMotorAxis(angular, axis, 0, axis == 0, axis == 1, axis == 2);
            dJointSetLMotorParam(linear, dParamFMax + dParamGroup * axis, m_dice.between(1, 20));
            dJointSetAMotorParam(angular, dParamFMax + dParamGroup * axis, m_dice.between(0.1, 2));
        }
    }

    Dice m_dice;
    std::vector<dJointID> m_linear;
};

// Slabs on more posts than they need, one above the other, that can hardly slide.
class Tables : public ManyParts {
public:
    explicit Tables(Stepper stepper) : ManyParts(stepper) {
        m_contactLimit = kMaxContacts;
        m_surface.mode = 0;
        m_surface.mu = stickyForce;
        dWorldSetCFM(world(), noSoftness);
        addParts([this](int part, Vector3 origin) {
            for (int post = 0; post < 2 + part % 4; ++post)
                addStaticBox(origin + Vector3{dReal(0.6) * post, 0, 0.5}, {0.2, 0.2, 1});
            for (int slab = 0; slab < 1 + part % 3; ++slab)
                addBox(origin + Vector3{0.6, 0, dReal(1.099) + dReal(0.199) * slab}, {3, 1, 0.2}, 5);
        });
    }

    void control() override {
        const dReal sideways = frameNumber() % 20 < 10 ? 4 : -4;
        dWorldSetGravity(world(), sideways, 0.5 * sideways, -9.81);
    }
};

// Boxes jammed between two walls, with hardly any limit to friction: what the solver is asked for cannot be.
class Jammed : public ManyParts {
public:
    explicit Jammed(Stepper stepper) : ManyParts(stepper) {
        addGround();
        m_surface.mode = 0;
        m_surface.mu = stickyForce;
        dWorldSetCFM(world(), noSoftness);
        addParts([this](int part, Vector3 origin) {
            const int boxes = 1 + part % 3;
            addStaticBox(origin + Vector3{-0.49, 0, 0.5}, {0.5, 2, 2});
            addStaticBox(origin + Vector3{dReal(0.49) * boxes, 0, 0.5}, {0.5, 2, 2}, dReal(0.01) * part);
            for (int i = 0; i < boxes; ++i)
                addBox(origin + Vector3{dReal(0.49) * i, 0, 0.24}, {0.5, 0.5, 0.5}, 1);
            addBox(origin + Vector3{0, 0, 0.73}, {0.5, 0.5, 0.5}, 20);
        });
    }
};

// Bodies of 1 mg and of 1000 kg, joined and stacked alternately.
class MassRatios : public ManyParts {
public:
    explicit MassRatios(Stepper stepper) : ManyParts(stepper) {
        addGround();
        m_surface.mode = 0;
        dWorldSetCFM(world(), noSoftness);
        addParts([this](int part, Vector3 origin) {
            if (part % 2 == 0) {
                for (int i = 0; i < 3; ++i)
                    addBox(origin + Vector3{0, 0, dReal(0.2) + dReal(0.399) * i}, {0.4, 0.4, 0.4},
                           mass(part / 2 + i));
                return;
            }
            dBodyID before = nullptr;
            for (int link = 0; link < 7; ++link) {
                const Vector3 place = origin + Vector3{dReal(0.5) * link, 0, 6};
                const dBodyID body = addSphere(place, 0.1, mass(part / 2 + link));
                addBall(body, before, place + Vector3{-0.25, 0, 0});
                before = body;
            }
        });
    }

private:
    static dReal mass(int number) { return number % 2 == 0 ? 1e-6 : 1e3; }
};

// Contacts without a direction among others: their rows are zero but for the softness.
class ZeroRows : public ManyParts {
public:
    explicit ZeroRows(Stepper stepper) : ManyParts(stepper), m_dice(11) {
        addGround();
        dWorldSetCFM(world(), 1e-10);
        m_surface.mode = 0;
        addParts([this](int part, Vector3 origin) {
            for (int i = 0; i < 2 + part % 3; ++i)
                addBox(origin + Vector3{0, 0, dReal(0.25) + dReal(0.499) * i}, {0.5, 0.5, 0.5}, 1);
        });
    }

protected:
    void setSurface(dContact &contact) override {
        ManyParts::setSurface(contact);
        if (!m_dice.oneIn(5)) return;
        contact.surface.mu = 0;  // friction would need a direction
        for (int i = 0; i < 3; ++i) contact.geom.normal[i] = 0;
    }

private:
    Dice m_dice;
};

}  // namespace

void addSingularIslands(Catalogue &catalogue) {
    const auto add = [&](const char *name, const char *meaning, Scenario::Make make) {
        catalogue.push_back({std::string("singular_islands/") + name, meaning, 30, std::move(make)});
    };
    add("closed_loops", "rings of hinges, no softness", make<ClosedLoops>(noSoftness));
    catalogue.back().steppers = {
        Stepper::Quick};  // the exact step ends in numbers that are none: faults/singular
    add("nearly_closed_loops", "rings of hinges, hardly any softness", make<ClosedLoops>(hardlyAnySoftness));
    add("doubled", "bodies joined several times, hardly any softness", make<Doubled>());
    add("rival_motors", "motors along the same axes, no softness", make<RivalMotors>());
    add("tables", "slabs on too many posts, no softness", make<Tables>());
    add("jammed", "boxes jammed between walls, no softness", make<Jammed>());
    add("mass_ratios", "stacks and chains of 1 mg and 1000 kg alternately, no softness", make<MassRatios>());
    add("zero_rows", "contacts without a direction, hardly any softness", make<ZeroRows>());
}

}  // namespace exactness
