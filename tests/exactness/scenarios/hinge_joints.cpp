#include "additions.h"
#include "joint_chains.h"

namespace exactness {

namespace {

class HingeJoints : public JointChains {
public:
    explicit HingeJoints(Stepper stepper) : JointChains(stepper) { build(); }

protected:
    dJointID join(int part, dBodyID before, dBodyID body, Vector3 anchor) override {
        const dJointID joint = dJointCreateHinge(world(), nullptr);
        dJointAttach(joint, before, body);
        dJointSetHingeAnchor(joint, anchor.x, anchor.y, anchor.z);
        dJointSetHingeAxis(joint, 0.1, 1, part % 3 == 0 ? 0.2 : 0);
        setLimits(joint, dJointSetHingeParam, 0, part, 0.6);
        return joint;
    }

    void drive(dJointID joint, int place) override {
        if (place % 4 == 1) dJointSetHingeParam(joint, dParamVel, frameNumber() % 40 < 20 ? 3 : -3);
        if (place % 4 == 2) dJointAddHingeTorque(joint, 0.5);
    }
};

}  // namespace

void addHingeJoints(Catalogue &catalogue) {
    catalogue.push_back(
        {"hinge_joints", "hinges with motors, stops, bounce and torques", 80, make<HingeJoints>()});
}

}  // namespace exactness
