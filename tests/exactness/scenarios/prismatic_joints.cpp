#include "additions.h"
#include "joint_chains.h"

namespace exactness {

namespace {

class PrismaticRotoide : public JointChains {
public:
    explicit PrismaticRotoide(Stepper stepper) : JointChains(stepper) { build(); }

protected:
    dJointID join(int part, dBodyID before, dBodyID body, Vector3 anchor) override {
        const dJointID joint = dJointCreatePR(world(), nullptr);
        dJointAttach(joint, before, body);
        dJointSetPRAnchor(joint, anchor.x, anchor.y, anchor.z);
        dJointSetPRAxis1(joint, 1, 0, 0);
        dJointSetPRAxis2(joint, 0, 1, 0);
        setLimits(joint, dJointSetPRParam, 0, part, 0.2);
        setLimits(joint, dJointSetPRParam, 1, part + 3, 0.6);
        return joint;
    }

    void drive(dJointID joint, int place) override {
        if (place % 3 == 0) dJointAddPRTorque(joint, 0.4);
    }
};

class PrismaticUniversal : public JointChains {
public:
    explicit PrismaticUniversal(Stepper stepper) : JointChains(stepper) { build(); }

protected:
    dJointID join(int part, dBodyID before, dBodyID body, Vector3 anchor) override {
        const dJointID joint = dJointCreatePU(world(), nullptr);
        dJointAttach(joint, before, body);
        dJointSetPUAnchor(joint, anchor.x, anchor.y, anchor.z);
        dJointSetPUAxis2(joint, 0, 0, 1);
        dJointSetPUAxis1(joint, 0, 1, 0);
        dJointSetPUAxisP(joint, 1, 0, 0);
        setLimits(joint, dJointSetPUParam, 0, part, 0.4);
        setLimits(joint, dJointSetPUParam, 1, part + 1, 0.4);
        setLimits(joint, dJointSetPUParam, 2, part + 2, 0.2);
        return joint;
    }
};

class Pistons : public JointChains {
public:
    explicit Pistons(Stepper stepper) : JointChains(stepper) { build(); }

protected:
    dJointID join(int part, dBodyID before, dBodyID body, Vector3 anchor) override {
        const dJointID joint = dJointCreatePiston(world(), nullptr);
        dJointAttach(joint, before, body);
        dJointSetPistonAnchor(joint, anchor.x, anchor.y, anchor.z);
        dJointSetPistonAxis(joint, 0.5, 0, 1);
        setLimits(joint, dJointSetPistonParam, 0, part, 0.2);
        setLimits(joint, dJointSetPistonParam, 1, part + 4, 0.5);
        return joint;
    }

    void drive(dJointID joint, int place) override {
        if (place % 3 == 0) dJointAddPistonForce(joint, frameNumber() % 20 < 10 ? 6 : -6);
    }
};

}  // namespace

void addPrismaticJoints(Catalogue &catalogue) {
    catalogue.push_back(
        {"prismatic_joints/rotoide", "PR joints with motors and stops", 80, make<PrismaticRotoide>()});
    catalogue.push_back(
        {"prismatic_joints/universal", "PU joints with motors and stops", 80, make<PrismaticUniversal>()});
    catalogue.push_back(
        {"prismatic_joints/piston", "pistons with motors, stops and forces", 80, make<Pistons>()});
}

}  // namespace exactness
