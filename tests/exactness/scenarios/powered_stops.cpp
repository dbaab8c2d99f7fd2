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

}  // namespace

void addPoweredStops(Catalogue &catalogue) {
    catalogue.push_back(
        {"powered_stops", "motors that push against stops, with fudge factors", 80, make<PoweredStops>()});
}

}  // namespace exactness
