// Rows of the exact step that go to a limit and come back: friction that sticks and slips, stops that are reached
// and left, motors at the end of their force; and islands of every small number of rows.
#include "additions.h"
#include "dice.h"
#include "scenario_scene.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace exactness {

namespace {

// Crates in rows and heaps, pushed to and fro so that some slide and some stick.
class PushedCrates : public ManyParts {
public:
    explicit PushedCrates(Stepper stepper) : ManyParts(stepper), m_dice(13) {
        addGround();
        addParts([this](int part, Vector3 origin) {
            for (int i = 0; i < 3 + part % 4; ++i) {
                const Vector3 place{dReal(0.41) * (i / 2), 0, dReal(0.2) + dReal(0.399) * (i % 2)};
                m_crates.push_back(addBox(origin + place, {0.4, 0.4, 0.4}, m_dice.between(0.5, 5)));
            }
        });
    }

    void control() override {
        for (const dBodyID crate : m_crates) {
            const dReal push = m_dice.between(-60, 60);
            dBodyAddForceAtRelPos(crate, push, m_dice.between(-20, 20), 0, 0, 0, m_dice.between(-0.2, 0.2));
        }
    }

protected:
    void setSurface(dContact &contact) override {
        constexpr int pyramids[] = {dContactApprox0, dContactApprox1, dContactApprox1_1, dContactApprox1_2};
        contact.surface.mode = pyramids[m_dice.below(4)];
        contact.surface.mu = m_dice.between(0.1, 1);
    }

private:
    Dice m_dice;
    std::vector<dBodyID> m_crates;
};

// Balls and boxes in a trough under rotating gravity: contacts begin and end on all sides.
class TurningGravity : public ManyParts {
public:
    explicit TurningGravity(Stepper stepper) : ManyParts(stepper) {
        addGround();
        addParts([this](int part, Vector3 origin) {
            for (const dReal side : {-1, 1}) {
                addStaticBox(origin + Vector3{side * dReal(0.75), 0, 0.5}, {0.2, 1.4, 1});
                addStaticBox(origin + Vector3{0, side * dReal(0.75), 0.5}, {1.4, 0.2, 1});
            }
            for (int i = 0; i < 2 + part % 4; ++i) {
                const Vector3 place = origin + Vector3{dReal(0.41) * (i % 2), dReal(0.2) * (i / 2),
                                                       dReal(0.2) + dReal(0.2) * i};
                if (i % 2 == 0) {
                    addBox(place, {0.4, 0.4, 0.4}, 1);
                } else {
                    addSphere(place, 0.2, 1);
                }
            }
        });
    }

    void control() override {
        const dReal angle = dReal(0.8) * frameNumber();
        dWorldSetGravity(world(), 20 * std::cos(angle), 20 * std::sin(angle), -12);
    }
};

// Trees of hinges between stops that are so narrow, and motors so weak, that all of them reach their limits
// all the time.
class LimitedJoints : public ManyParts {
public:
    explicit LimitedJoints(Stepper stepper) : ManyParts(stepper), m_dice(17) {
        addParts([this](int part, Vector3 origin) {
            std::vector<dBodyID> limbs;
            for (int limb = 0; limb < 2 + part % 7; ++limb) {
                const Vector3 place = origin + Vector3{dReal(0.4) * limb, 0, 2};
                limbs.push_back(addBody(place, world()));
                const dBodyID parent = limb == 0 ? nullptr : limbs[static_cast<std::size_t>(limb - 1) / 2];
                const dJointID hinge =
                    addHinge(limbs.back(), parent, place + Vector3{-0.2, 0, 0}, scenes::kAxisY);
                dJointSetHingeParam(hinge, dParamLoStop, -0.01);
                dJointSetHingeParam(hinge, dParamHiStop, 0.01 * (limb % 3));
                dJointSetHingeParam(hinge, dParamBounce, part % 2 == 0 ? 0.9 : 0);
                dJointSetHingeParam(hinge, dParamStopCFM, part % 3 == 0 ? 0 : 1e-4);
            }
        });
    }

    void control() override {
        for (const dJointID hinge : m_inventory.joints) {
            dJointSetHingeParam(hinge, dParamVel, m_dice.between(-4, 4));
            dJointSetHingeParam(hinge, dParamFMax, m_dice.oneIn(3) ? 0 : m_dice.between(0, 8));
        }
    }

private:
    Dice m_dice;
};

// Forty islands, of one row, two, and so on to forty, half of them with limits.
class EveryCount : public ManyParts {
public:
    explicit EveryCount(Stepper stepper) : ManyParts(stepper), m_dice(19) {
        addParts([this](int part, Vector3 origin) { addIsland(part + 1, origin); }, 40);
    }

    void control() override {
        for (const dJointID joint : m_inventory.joints) {
            if (dJointGetType(joint) != dJointTypeLMotor) continue;
            for (int axis = 0; axis < dJointGetLMotorNumAxes(joint); ++axis) {
                dJointSetLMotorParam(joint, dParamVel + dParamGroup * axis, m_dice.between(-1, 1));
                dJointSetLMotorParam(joint, dParamFMax + dParamGroup * axis, m_dice.between(0.5, 12));
            }
        }
    }

private:
    // Bodies in a chain, each held by a ball joint (3 rows) and pushed by a motor along up to three axes, one
    // row each.
    void addIsland(int rows, Vector3 place) {
        dBodyID body = nullptr;
        while (rows >= 3) {
            const dBodyID before = body;
            body = addBody(place, world());
            addBall(body, before, place + Vector3{-0.2, 0, 0});
            const int axes = std::min(rows - 3, 3);
            addMotor(body, axes);
            rows -= 3 + axes;
            place.x += 0.4;
        }
        addMotor(body != nullptr ? body : addBody(place, world()), rows);
    }

    void addMotor(dBodyID body, int axes) {
        if (axes == 0) return;
        const dJointID motor = add(dJointCreateLMotor(world(), nullptr));
        dJointAttach(motor, body, nullptr);
        dJointSetLMotorNumAxes(motor, axes);
        dJointSetLMotorAxis(motor, 0, 0, 0, 0, 1);
        if (axes > 1) dJointSetLMotorAxis(motor, 1, 0, 1, 0.2, 0);
        if (axes > 2) dJointSetLMotorAxis(motor, 2, 0, 0, 1, 0.3);
    }

    Dice m_dice;
};

// Piles with alternately few and many contacts, of another kind each, and whose joints are switched off and
// on.
class ChangingCounts : public ManyParts {
public:
    explicit ChangingCounts(Stepper stepper) : ManyParts(stepper), m_dice(23) {
        addGround();
        addParts([this](int part, Vector3 origin) {
            dBodyID below = nullptr;
            for (int i = 0; i < 1 + part % 5; ++i) {
                const Vector3 place = origin + Vector3{dReal(0.03) * i, 0, dReal(0.25) + dReal(0.499) * i};
                const dBodyID box = addBox(place, {0.5, 0.5, 0.5}, 1);
                if (i % 2 == 1) addHinge(box, below, place + Vector3{0, 0, -0.25}, scenes::kAxisX);
                below = box;
            }
        });
    }

    void control() override {
        m_contactLimit = 1 + m_dice.below(kMaxContacts);
        for (const dJointID joint : m_inventory.joints) {
            if (m_dice.oneIn(2)) {
                dJointDisable(joint);
            } else {
                dJointEnable(joint);
            }
        }
    }

protected:
    void setSurface(dContact &contact) override {
        constexpr int modes[] = {0,
                                 dContactApprox1,
                                 dContactRolling,
                                 dContactApprox1 | dContactRolling,
                                 dContactSlip1 | dContactSlip2,
                                 dContactBounce};
        contact.surface.mode = modes[m_dice.below(6)];
        contact.surface.mu = m_dice.oneIn(4) ? 0 : m_dice.between(0, 2);
        contact.surface.rho = contact.surface.rho2 = contact.surface.rhoN = m_dice.between(0, 0.1);
        contact.surface.slip1 = contact.surface.slip2 = 0.01;
        contact.surface.bounce = 0.7;
    }

private:
    Dice m_dice;
};

// Bodies held alike along each axis and drawn along the diagonal: the rows that hold one reach their limits
// at the same length of a push, where which of them comes first depends on their order alone.
class Ties : public ManyParts {
public:
    explicit Ties(Stepper stepper) : ManyParts(stepper) {
        dWorldSetGravity(world(), 0, 0, 0);
        dWorldSetCFM(world(), 0);
        addParts([this](int part, Vector3 origin) {
            const dBodyID body = addBody(origin, world());
            const bool drawsFirst = part % 2 == 0;
            if (drawsFirst) addDraw(body);
            addHold(body, 2 + part / 2 % 2);
            if (!drawsFirst) addDraw(body);
        });
    }

    void control() override {
        for (const dJointID draw : m_draws)
            dJointSetLMotorParam(draw, dParamVel, frameNumber() % 4 < 2 ? 2 : -2);
        for (const dJointID hold : m_holds) {
            for (int axis = 0; axis < 3; ++axis)
                dJointSetLMotorParam(hold, dParamFMax + dParamGroup * axis, 1 + frameNumber() % 8);
        }
    }

private:
    void addDraw(dBodyID body) {
        m_draws.push_back(addMotor(body, 1));
        dJointSetLMotorAxis(m_draws.back(), 0, 0, 1, 1, 1);
        dJointSetLMotorParam(m_draws.back(), dParamFMax, 100);
    }

    void addHold(dBodyID body, int axes) {
        m_holds.push_back(addMotor(body, axes));
        for (int axis = 0; axis < axes; ++axis)
            dJointSetLMotorAxis(m_holds.back(), axis, 0, axis == 0, axis == 1, axis == 2);
    }

    dJointID addMotor(dBodyID body, int axes) {
        const dJointID motor = add(dJointCreateLMotor(world(), nullptr));
        dJointAttach(motor, body, nullptr);
        dJointSetLMotorNumAxes(motor, axes);
        return motor;
    }

    std::vector<dJointID> m_draws, m_holds;
};

}  // namespace

void addWanderingRows(Catalogue &catalogue) {
    const auto add = [&](const char *name, const char *meaning, Scenario::Make make) {
        catalogue.push_back({std::string("wandering_rows/") + name, meaning, 30, std::move(make)});
    };
    add("pushed_crates", "crates pushed back and forth, that stick and slip", make<PushedCrates>());
    add("turning_gravity", "boxes and balls in troughs, thrown from side to side", make<TurningGravity>());
    add("limited_joints", "trees of joints at their stops, with weak motors", make<LimitedJoints>());
    add("every_count", "islands of one row to forty, half with limits", make<EveryCount>());
    add("changing_counts", "piles whose rows are another number in each frame", make<ChangingCounts>());
    add("ties", "bodies held alike along all axes: rows that meet their limits at the same time",
        make<Ties>());
}

}  // namespace exactness
