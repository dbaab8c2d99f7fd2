#include "loader/scene/ode_joint.h"

#include "loader/scene/joint_axis.h"
#include "loader/scene/ode_types.h"

namespace worlds {

namespace {

template <class Set>
void setVector(Set set, dJointID joint, const Vector3 &vector) {
    set(joint, toReal(vector.x), toReal(vector.y), toReal(vector.z));
}

// ODE counts the motion of the first body against the second: the child comes first.
void attach(dJointID joint, dBodyID parent, dBodyID child) { dJointAttach(joint, child, parent); }

dJointID createHinge(dWorldID world, const Joint &source, dBodyID parent, dBodyID child) {
    const dJointID joint = dJointCreateHinge(world, nullptr);
    attach(joint, parent, child);
    setVector(dJointSetHingeAnchor, joint, source.anchor);
    setVector(dJointSetHingeAxis, joint, source.axes[0].direction);
    return joint;
}

dJointID createSlider(dWorldID world, const Joint &source, dBodyID parent, dBodyID child) {
    const dJointID joint = dJointCreateSlider(world, nullptr);
    attach(joint, parent, child);
    setVector(dJointSetSliderAxis, joint, source.axes[0].direction);
    return joint;
}

dJointID createBall(dWorldID world, const Joint &source, dBodyID parent, dBodyID child) {
    const dJointID joint = dJointCreateBall(world, nullptr);
    attach(joint, parent, child);
    setVector(dJointSetBallAnchor, joint, source.anchor);
    return joint;
}

bool isParallel(const Vector3 &a, const Vector3 &b) { return a.cross(b).length() < 1e-6; }

// ODE's first axis moves with the first body, here the child; SDF's first axis with the parent.
dJointID createUniversal(dWorldID world, const Joint &source, dBodyID parent, dBodyID child) {
    const dJointID joint = dJointCreateUniversal(world, nullptr);
    attach(joint, parent, child);
    setVector(dJointSetUniversalAnchor, joint, source.anchor);
    const Vector3 &first = source.axes[1].direction, &second = source.axes[0].direction;
    // ODE complains when its two axes are parallel, even in between.
    dVector3 current;
    dJointGetUniversalAxis2(joint, current);
    if (isParallel(first, toVector(current)))
        setVector(dJointSetUniversalAxis1, joint, first.cross(second));
    else
        setVector(dJointSetUniversalAxis1, joint, first);
    setVector(dJointSetUniversalAxis2, joint, second);
    setVector(dJointSetUniversalAxis1, joint, first);
    return joint;
}

// Only ODE's first axis has a suspension and limits, so the parent has to come first; the axes are
// turned round to make the child's motion count.
dJointID createHinge2(dWorldID world, const Joint &source, dBodyID parent, dBodyID child) {
    if (!parent || !child)
        throw LoadError(LoadError::Kind::Unsupported, source.place,
                        "revolute2 between a body and the static world: not supported");
    const dJointID joint = dJointCreateHinge2(world, nullptr);
    dJointAttach(joint, parent, child);
    setVector(dJointSetHinge2Anchor, joint, source.anchor);
    const Vector3 first = -source.axes[0].direction, second = -source.axes[1].direction;
    const dVector3 axis1 = {toReal(first.x), toReal(first.y), toReal(first.z)};
    const dVector3 axis2 = {toReal(second.x), toReal(second.y), toReal(second.z)};
    dJointSetHinge2Axes(joint, axis1, axis2);
    return joint;
}

dJointID createFixed(dWorldID world, dBodyID parent, dBodyID child) {
    const dJointID joint = dJointCreateFixed(world, nullptr);
    attach(joint, parent, child);
    dJointSetFixed(joint);
    return joint;
}

dJointID create(dWorldID world, const Joint &source, dBodyID parent, dBodyID child) {
    switch (source.type) {
        case JointType::Revolute:
            return createHinge(world, source, parent, child);
        case JointType::Prismatic:
            return createSlider(world, source, parent, child);
        case JointType::Ball:
            return createBall(world, source, parent, child);
        case JointType::Universal:
            return createUniversal(world, source, parent, child);
        case JointType::Revolute2:
            return createHinge2(world, source, parent, child);
        case JointType::Fixed:
            break;
    }
    return createFixed(world, parent, child);
}

void setAxis(const JointAxisHandle &handle, const Joint &joint, const JointAxis &axis) {
    handle.set(dParamLoStop, toReal(axis.lower));
    handle.set(dParamHiStop, toReal(axis.upper));
    if (axis.friction > 0) {  // a motor of velocity zero whose force is limited to the friction
        handle.set(dParamVel, 0);
        handle.set(dParamFMax, toReal(axis.friction));
    }
    if (joint.cfm) handle.set(dParamCFM, toReal(*joint.cfm));
    if (joint.stopCfm) handle.set(dParamStopCFM, toReal(*joint.stopCfm));
    if (joint.stopErp) handle.set(dParamStopERP, toReal(*joint.stopErp));
    if (joint.bounce) handle.set(dParamBounce, toReal(*joint.bounce));
    if (joint.fudgeFactor) handle.set(dParamFudgeFactor, toReal(*joint.fudgeFactor));
}

// Sets the softness of joints without a free axis.
void setSoftness(dJointID joint, const Joint &source) {
    const auto set = source.type == JointType::Ball ? dJointSetBallParam : dJointSetFixedParam;
    if (source.cfm) set(joint, dParamCFM, toReal(*source.cfm));
    if (source.erp) set(joint, dParamERP, toReal(*source.erp));
}

}  // namespace

dJointID createJoint(dWorldID world, const Joint &source, dBodyID parent, dBodyID child) {
    if (!parent && !child) return nullptr;
    const dJointID joint = create(world, source, parent, child);
    if (source.axes.empty()) setSoftness(joint, source);
    for (std::size_t i = 0; i < source.axes.size(); ++i)
        setAxis(JointAxisHandle(joint, static_cast<int>(i)), source, source.axes[i]);
    if (source.motorForce && !source.axes.empty()) {
        JointAxisHandle(joint, 0).set(dParamVel, toReal(source.motorSpeed.value_or(0)));
        JointAxisHandle(joint, 0).set(dParamFMax, toReal(*source.motorForce));
    }
    if (source.suspensionErp) dJointSetHinge2Param(joint, dParamSuspensionERP, toReal(*source.suspensionErp));
    if (source.suspensionCfm) dJointSetHinge2Param(joint, dParamSuspensionCFM, toReal(*source.suspensionCfm));
    return joint;
}

}  // namespace worlds
