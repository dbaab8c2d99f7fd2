#include "additions.h"
#include "joint_chains.h"

namespace exactness {

namespace {

class UniversalJoints : public JointChains {
public:
    explicit UniversalJoints(Stepper stepper) : JointChains(stepper) { build(); }

protected:
    dJointID join(int part, dBodyID before, dBodyID body, Vector3 anchor) override {
        const dJointID joint = dJointCreateUniversal(world(), nullptr);
        dJointAttach(joint, before, body);
        dJointSetUniversalAnchor(joint, anchor.x, anchor.y, anchor.z);
        dJointSetUniversalAxis2(joint, 0, 0, 1);
        dJointSetUniversalAxis1(joint, 0, 1, 0);
        setLimits(joint, dJointSetUniversalParam, 0, part, 0.5);
        setLimits(joint, dJointSetUniversalParam, 1, part + 2, 0.4);
        return joint;
    }

    void drive(dJointID joint, int place) override {
        if (place % 3 == 0) dJointAddUniversalTorques(joint, 0.3, 0.2);
    }
};

}  // namespace

void addUniversalJoints(Catalogue &catalogue) {
    catalogue.push_back({"universal_joints", "universal joints with motors and stops on both axes", 80,
                         make<UniversalJoints>()});
}

}  // namespace exactness
