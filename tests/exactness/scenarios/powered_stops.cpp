#include "additions.h"
#include "scenario_scene.h"

namespace exactness {

namespace {

// Motors that push against a stop. Upstream then adds the motor's force, scaled by the fudge factor, to the
// accumulators of both bodies in the middle of building the rows.
class PoweredStops : public ManyParts {
public:
    explicit PoweredStops(Stepper stepper) : ManyParts(stepper) {
        addParts([this](int part, Vector3 origin) {
            dBodyID before = nullptr;
            for (int i = 0; i < 6; ++i) {
                const Vector3 place = origin + Vector3{dReal(0.4) * i, 0, 1};
                const dBodyID body = addBox(place, {0.3, 0.2, 0.2}, 1);
                addFeedback(i % 2 == 0 ? addPoweredHinge(part, before, body, place)
                                       : addPoweredSlider(part, before, body));
                before = body;
            }
        });
    }

    void control() override {
        if (frameNumber() % 20 != 0) return;
        for (dJointID joint : m_inventory.joints) {
            if (dJointGetType(joint) == dJointTypeHinge) {
                dJointSetHingeParam(joint, dParamVel, -dJointGetHingeParam(joint, dParamVel));
            } else {
                dJointSetSliderParam(joint, dParamVel, -dJointGetSliderParam(joint, dParamVel));
            }
        }
    }

private:
    dJointID addPoweredHinge(int part, dBodyID before, dBodyID body, Vector3 place) {
        const dJointID joint = addHinge(body, before, place, scenes::kAxisY);
        power(joint, dJointSetHingeParam, part);
        return joint;
    }

    dJointID addPoweredSlider(int part, dBodyID before, dBodyID body) {
        const dJointID joint = add(dJointCreateSlider(world(), nullptr));
        dJointAttach(joint, body, before);
        dJointSetSliderAxis(joint, 1, 0, 0.2);
        power(joint, dJointSetSliderParam, part);
        return joint;
    }

    static void power(dJointID joint, void (*set)(dJointID, int, dReal), int part) {
        set(joint, dParamLoStop, -0.05);
        set(joint, dParamHiStop, 0.05);
        set(joint, dParamVel, part % 2 == 0 ? 3 : -3);
        set(joint, dParamFMax, 30);
        set(joint, dParamFudgeFactor, 0.25 * (part % 5));
        if (part % 3 == 0) set(joint, dParamBounce, 0.4);
        // Both stops at one place: the joint is locked.
        if (part % 8 == 7) set(joint, dParamLoStop, 0.05);
    }
};

// Hinges that rest on a stop when it is taken away: made infinite, or crossed with the other one. Upstream's hinge then goes on writing the stop's
// row, which it no longer counts: into rows of its own and of the next joint, and behind the last one's. What dWorldStep makes of that has bits, too.
class StopsTakenAway : public ManyParts {
public:
    explicit StopsTakenAway(Stepper stepper) : ManyParts(stepper) {
        addParts([this](int part, Vector3 origin) {
            const dBodyID arm = addBox(origin + Vector3{0, 0, 1}, {0.3, 0.2, 0.2}, 1);
            addFeedback(addHinge(arm, nullptr, origin + Vector3{-0.2, 0, 1}, {0, 1, 0}));  // it falls onto its high stop
            if (part % 2 == 0) return;
            const dBodyID weight = addBox(origin + Vector3{0.4, 0, 1}, {0.3, 0.2, 0.2}, 1);
            addFeedback(part % 4 == 1 ? addBall(weight, arm, origin + Vector3{0.2, 0, 1}) : addBall(arm, weight, origin + Vector3{0.2, 0, 1}));
        });
    }

    void control() override {
        const int phase = frameNumber() % 24;
        if (phase != 0 && phase != 16) return;
        int number = 0;
        for (dJointID joint : m_inventory.joints) {
            if (dJointGetType(joint) != dJointTypeHinge) continue;
            const bool isCrossed = ++number % 2 == 0;
            dJointSetHingeParam(joint, dParamLoStop, phase == 0 ? -0.05 : isCrossed ? 0.1 : -dInfinity);
            dJointSetHingeParam(joint, dParamHiStop, phase == 0 ? 0.05 : isCrossed ? -0.1 : dInfinity);
        }
    }
};

}  // namespace

void addPoweredStops(Catalogue &catalogue) {
    catalogue.push_back(
        {"powered_stops", "motors that push against stops, with fudge factors", 80, make<PoweredStops>()});
    catalogue.push_back({"powered_stops/taken_away", "hinges that rest on stops which are taken away", 80, make<StopsTakenAway>()});
    catalogue.back().steppers = {Stepper::World};  // upstream's dWorldQuickStep writes behind its memory, and may crash
}

}  // namespace exactness
