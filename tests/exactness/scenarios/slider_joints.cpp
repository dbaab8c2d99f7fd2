#include "additions.h"
#include "joint_chains.h"

namespace exactness {

namespace {

class SliderJoints : public JointChains {
public:
    explicit SliderJoints(Stepper stepper) : JointChains(stepper) { build(); }

protected:
    dJointID join(int part, dBodyID before, dBodyID body, Vector3) override {
        const dJointID joint = dJointCreateSlider(world(), nullptr);
        dJointAttach(joint, before, body);
        dJointSetSliderAxis(joint, 0.3, 0.1 * (part % 3), 1);
        setLimits(joint, dJointSetSliderParam, 0, part, 0.25);
        return joint;
    }

    void drive(dJointID joint, int place) override {
        if (place % 3 == 0) dJointAddSliderForce(joint, frameNumber() % 30 < 15 ? 12 : -4);
    }
};

}  // namespace

void addSliderJoints(Catalogue &catalogue) {
    catalogue.push_back(
        {"slider_joints", "sliders with motors, stops, bounce and forces", 80, make<SliderJoints>()});
}

}  // namespace exactness
