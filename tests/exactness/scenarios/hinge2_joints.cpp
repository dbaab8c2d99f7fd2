#include "additions.h"
#include "joint_chains.h"

namespace exactness {

namespace {

// A hinge-2 needs two bodies, so the first link of a chain hangs from the world by a ball joint.
class Hinge2Joints : public JointChains {
public:
    explicit Hinge2Joints(Stepper stepper) : JointChains(stepper) { build(); }

protected:
    dJointID join(int part, dBodyID before, dBodyID body, Vector3 anchor) override {
        if (before == nullptr) return hang(body, anchor);
        const dJointID joint = dJointCreateHinge2(world(), nullptr);
        dJointAttach(joint, before, body);
        dJointSetHinge2Anchor(joint, anchor.x, anchor.y, anchor.z);
        const dVector3 steering = {0, 0, 1}, wheel = {0, 1, 0};
        dJointSetHinge2Axes(joint, steering, wheel);
        setLimits(joint, dJointSetHinge2Param, 0, part, 0.4);
        setLimits(joint, dJointSetHinge2Param, 1, part + 1, 0.5);
        dJointSetHinge2Param(joint, dParamSuspensionERP, 0.4);
        dJointSetHinge2Param(joint, dParamSuspensionCFM, 0.02);
        return joint;
    }

    void drive(dJointID joint, int place) override {
        if (dJointGetType(joint) == dJointTypeHinge2 && place % 3 == 0)
            dJointAddHinge2Torques(joint, 0.4, -0.3);
    }

private:
    dJointID hang(dBodyID body, Vector3 anchor) {
        const dJointID joint = dJointCreateBall(world(), nullptr);
        dJointAttach(joint, body, nullptr);
        dJointSetBallAnchor(joint, anchor.x, anchor.y, anchor.z);
        return joint;
    }
};

}  // namespace

void addHinge2Joints(Catalogue &catalogue) {
    catalogue.push_back(
        {"hinge2_joints", "hinge-2 joints with suspension, motors and stops", 80, make<Hinge2Joints>()});
}

}  // namespace exactness
