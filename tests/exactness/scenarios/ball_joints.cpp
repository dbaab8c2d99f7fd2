#include "additions.h"
#include "joint_chains.h"

namespace exactness {

namespace {

class BallJoints : public JointChains {
public:
    explicit BallJoints(Stepper stepper) : JointChains(stepper) { build(); }

protected:
    dJointID join(int part, dBodyID before, dBodyID body, Vector3 anchor) override {
        const dJointID joint = dJointCreateBall(world(), nullptr);
        dJointAttach(joint, before, body);
        dJointSetBallAnchor(joint, anchor.x, anchor.y, anchor.z);
        if (part % 3 == 1) dJointSetBallParam(joint, dParamCFM, 1e-3);
        if (part % 3 == 2) dJointSetBallParam(joint, dParamERP, 0.6);
        return joint;
    }
};

}  // namespace

void addBallJoints(Catalogue &catalogue) {
    catalogue.push_back(
        {"ball_joints", "chains of ball joints, soft and stiff, breaking", 80, make<BallJoints>()});
}

}  // namespace exactness
