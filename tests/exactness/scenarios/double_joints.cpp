#include "additions.h"
#include "joint_chains.h"

namespace exactness {

namespace {

class DoubleJoints : public JointChains {
public:
    DoubleJoints(Stepper stepper, bool hinges) : JointChains(stepper), m_hinges(hinges) { build(); }

protected:
    // A double hinge needs two bodies, so the first link of a chain always hangs by a double ball.
    dJointID join(int part, dBodyID before, dBodyID body, Vector3 anchor) override {
        return m_hinges && before != nullptr ? hinge(part, before, body, anchor)
                                             : ball(part, before, body, anchor);
    }

private:
    dJointID ball(int part, dBodyID before, dBodyID body, Vector3 anchor) {
        const dJointID joint = dJointCreateDBall(world(), nullptr);
        dJointAttach(joint, before, body);
        dJointSetDBallAnchor1(joint, anchor.x - 0.1, anchor.y, anchor.z);
        dJointSetDBallAnchor2(joint, anchor.x + 0.1, anchor.y, anchor.z + 0.05);
        if (part % 3 == 1) dJointSetDBallParam(joint, dParamCFM, 1e-3);
        if (part % 3 == 2) dJointSetDBallDistance(joint, 0.3);
        return joint;
    }

    dJointID hinge(int part, dBodyID before, dBodyID body, Vector3 anchor) {
        const dJointID joint = dJointCreateDHinge(world(), nullptr);
        dJointAttach(joint, before, body);
        dJointSetDHingeAnchor1(joint, anchor.x - 0.1, anchor.y, anchor.z);
        dJointSetDHingeAnchor2(joint, anchor.x + 0.1, anchor.y, anchor.z);
        dJointSetDHingeAxis(joint, 0, 1, 0);
        if (part % 3 == 1) dJointSetDHingeParam(joint, dParamERP, 0.5);
        return joint;
    }

    bool m_hinges;
};

}  // namespace

void addDoubleJoints(Catalogue &catalogue) {
    catalogue.push_back(
        {"double_joints/ball", "double ball joints, soft and stretched", 80, make<DoubleJoints>(false)});
    catalogue.push_back(
        {"double_joints/hinge", "double hinges, soft and stiff", 80, make<DoubleJoints>(true)});
}

}  // namespace exactness
