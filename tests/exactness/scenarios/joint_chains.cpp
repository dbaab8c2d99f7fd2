#include "joint_chains.h"

namespace exactness {

namespace {

constexpr dReal breakingLoad = 220;  // N, of the force and of the torque at a lever of 0.25 m
constexpr int everyBreakable = 4;    // every fourth joint may break

}  // namespace

void JointChains::build() {
    addGround();
    addParts([this](int part, Vector3 origin) {
        dBodyID before = nullptr;
        for (int link = 0; link < links; ++link) {
            const Vector3 anchor = origin + Vector3{length * link, 0, 1.1};
            const dBodyID body = addBox(anchor + Vector3{length / 2, dReal(0.02) * link, 0},
                                        {length * dReal(0.9), 0.1, 0.12}, 1);
            dBodySetAngularVel(body, 0.3 * link, 0.1 * part, 0.2);
            addFeedback(add(join(part, before, body, anchor)));
            before = body;
        }
    });
}

void JointChains::control() {
    for (std::size_t i = 0; i < m_inventory.joints.size(); ++i)
        drive(m_inventory.joints[i], static_cast<int>(i));
    breakOverloaded();
}

void JointChains::breakOverloaded() {
    const std::vector<dJointID> joints = m_inventory.joints;
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const dJointFeedback *feedback = dJointGetFeedback(joints[i]);
        const dReal load = dCalcVectorLength3(feedback->f1) + 4 * dCalcVectorLength3(feedback->t1);
        const bool overloaded = load > breakingLoad;
        if (!overloaded || i % everyBreakable != 0) continue;
        note("joint broken", static_cast<double>(i));
        destroy(joints[i]);
    }
}

void JointChains::setLimits(dJointID joint, SetParameter set, int axis, int part, dReal range) {
    const auto put = [&](int parameter, dReal value) { set(joint, parameter + axis * dParamGroup, value); };
    const auto stops = [&] {
        put(dParamLoStop, -range);
        put(dParamHiStop, range * (axis + 1) / 2);
    };
    const auto motor = [&] {
        put(dParamVel, part % 2 == 0 ? 2 : -2);
        put(dParamFMax, 15);
    };
    switch (part % 6) {
        case 0:
            break;
        case 1:
            motor();
            break;
        case 2:
            stops();
            break;
        case 3:
            stops();
            put(dParamBounce, 0.7);
            break;
        case 4:
            stops();
            motor();
            put(dParamFudgeFactor, 0.3);
            break;
        case 5:
            stops();
            put(dParamStopERP, 0.4);
            put(dParamStopCFM, 1e-3);
            put(dParamCFM, 1e-4);
            break;
    }
}

}  // namespace exactness
