#include "additions.h"
#include "joint_chains.h"

namespace exactness {

namespace {

class FixedJoints : public JointChains {
public:
    explicit FixedJoints(Stepper stepper) : JointChains(stepper) { build(); }

protected:
    dJointID join(int part, dBodyID before, dBodyID body, Vector3) override {
        const dJointID joint = dJointCreateFixed(world(), nullptr);
        dJointAttach(joint, before, body);
        dJointSetFixed(joint);
        if (part % 3 == 1) dJointSetFixedParam(joint, dParamCFM, 1e-3);
        if (part % 3 == 2) dJointSetFixedParam(joint, dParamERP, 0.5);
        return joint;
    }
};

}  // namespace

void addFixedJoints(Catalogue &catalogue) {
    catalogue.push_back(
        {"fixed_joints", "beams of fixed joints that sag and break", 80, make<FixedJoints>()});
}

}  // namespace exactness
