#include "loader/read/read_joint.h"

#include "loader/read/element_rules.h"
#include "loader/read/value_check.h"
#include "support/text.h"

#include <cmath>
#include <unordered_map>

namespace worlds {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The last version in which axes are written in the frame of the model instead of that of the joint.
constexpr int kAxesOfModel = 4;

JointType typeOf(const Element &joint) {
    static const std::unordered_map<std::string, JointType> types = {
        {"revolute", JointType::Revolute},   {"continuous", JointType::Revolute},
        {"prismatic", JointType::Prismatic}, {"ball", JointType::Ball},
        {"universal", JointType::Universal}, {"revolute2", JointType::Revolute2},
        {"fixed", JointType::Fixed}};
    return types.at(joint.attribute("type"));  // element_check.h lets no other pass
}

unsigned axisCount(JointType type) {
    switch (type) {
        case JointType::Revolute:
        case JointType::Prismatic:
            return 1;
        case JointType::Universal:
        case JointType::Revolute2:
            return 2;
        default:
            return 0;
    }
}

// ODE measures angles between -π and π: a single stop beyond that would be reached from the wrong side.
void checkAngleLimits(const JointAxis &axis, const Place &place, const Reading &reading) {
    const bool unreachable = axis.lower < -kPi && axis.upper > kPi;
    const bool lowerTooFar = std::isfinite(axis.lower) && axis.lower < -kPi;
    const bool upperTooFar = std::isfinite(axis.upper) && axis.upper > kPi;
    if (!unreachable && (lowerTooFar || upperTooFar))
        reading.issues.unsupported(place, "one of two stops beyond half a turn");
}

void readLimits(const Element &source, JointAxis &axis) {
    const Element *const limit = source.child("limit");
    if (!limit) return;
    axis.lower = limit->childLimit("lower", -infinity);
    axis.upper = limit->childLimit("upper", infinity);
    if (axis.lower <= -largestNumber) axis.lower = -infinity;
    if (axis.upper >= largestNumber) axis.upper = infinity;
    if (axis.lower > axis.upper) source.fail("lower limit above upper limit");
    axis.maxForce = limitOrNone(limit->childLimit("effort", -1));
    axis.maxSpeed = limitOrNone(limit->childLimit("velocity", -1));
}

// The rotation, in the model, of the frame in which an axis is written.
Quaternion axisFrame(const Element &axis, const Element *xyz, const Scope &model, const Quaternion &joint) {
    const std::string frame = xyz ? xyz->attributeOrEmpty("expressed_in") : std::string();
    if (!frame.empty()) return model.pose(frame, *xyz, "expressed_in").rotation;
    return axis.childFlag("use_parent_model_frame", axis.file().version <= kAxesOfModel) ? Quaternion()
                                                                                         : joint;
}

// `modelPose` is in the world, `joint` is the joint's rotation in the model.
JointAxis readAxis(const Element &source, const Scope &model, const Pose &modelPose,
                   const Quaternion &joint) {
    JointAxis axis;
    const Element *const xyz = source.child("xyz");
    const Vector3 direction = source.childVector("xyz", {0, 0, 1}).normalized();
    axis.direction = modelPose.rotation * (axisFrame(source, xyz, model, joint) * direction);
    readLimits(source, axis);
    if (const Element *const dynamics = source.child("dynamics")) {
        axis.friction = dynamics->childNumber("friction", 0);
        axis.damping = dynamics->childNumber("damping", 0);
        axis.springStiffness = dynamics->childNumber("spring_stiffness", 0);
        axis.springReference = dynamics->childNumber("spring_reference", 0);
    }
    return axis;
}

std::optional<double> optionalNumber(const Element *element, const std::string &child) {
    if (!element || !element->child(child)) return std::nullopt;
    return element->child(child)->number();
}

void readOde(const Element &ode, Joint &joint, const Reading &reading) {
    joint.cfm = optionalNumber(&ode, "cfm");
    joint.erp = optionalNumber(&ode, "erp");
    if (joint.erp && joint.type != JointType::Ball && joint.type != JointType::Fixed) {
        reading.issues.unsupported(ode.child("erp")->place(), "on a joint other than ball and fixed");
        joint.erp.reset();  // ODE takes it for these two alone
    }
    for (const char *const ofAnAxis : {"bounce", "fudge_factor", "max_force", "velocity", "limit"})
        if (const Element *child = ode.child(ofAnAxis); child && axisCount(joint.type) == 0)
            reading.issues.unsupported(child->place(), "on a joint without an axis");
    joint.bounce = optionalNumber(&ode, "bounce");
    joint.fudgeFactor = optionalNumber(&ode, "fudge_factor");
    joint.motorForce = optionalNumber(&ode, "max_force");
    joint.motorSpeed = optionalNumber(&ode, "velocity");
    joint.stopCfm = optionalNumber(ode.child("limit"), "cfm");
    joint.stopErp = optionalNumber(ode.child("limit"), "erp");
    if (const Element *suspension = ode.child("suspension")) {
        if (joint.type != JointType::Revolute2)
            return reading.issues.unsupported(suspension->place(), "on a joint other than revolute2");
        joint.suspensionCfm = optionalNumber(suspension, "cfm");
        joint.suspensionErp = optionalNumber(suspension, "erp");
    }
}

void readPhysics(const Element &physics, Joint &joint, const Reading &reading) {
    joint.feedback = physics.childFlag("provide_feedback", false);
    if (const Element *ode = physics.child("ode")) {
        joint.feedback = joint.feedback || ode->childFlag("provide_feedback", false);
        readOde(*ode, joint, reading);
    }
}

void readAxes(const Element &source, const Scope &model, const Pose &modelPose, Joint &joint,
              const Reading &reading) {
    const unsigned count = axisCount(joint.type);
    const Quaternion inModel = model.pose(source).rotation;
    const char *const names[] = {"axis", "axis2"};
    for (unsigned i = 0; i < 2; ++i) {
        const Element *const axis = source.child(names[i]);
        if (i < count && !axis) source.fail(std::string("needs <") + names[i] + ">");
        if (i >= count && axis) reading.issues.warn(axis->place(), "left aside: a joint of this type has none");
        if (i >= count) continue;
        joint.axes.push_back(readAxis(*axis, model, modelPose, inModel));
        if (joint.type != JointType::Prismatic) checkAngleLimits(joint.axes.back(), axis->place(), reading);
    }
    if (joint.type == JointType::Revolute2 &&
        (std::isfinite(joint.axes[1].lower) || std::isfinite(joint.axes[1].upper)))
        reading.issues.unsupported(source.child("axis2")->place(), "limits of the second axis");
    if (count == 2 && joint.axes[0].direction.cross(joint.axes[1].direction).length() < 1e-6)
        source.fail("the two axes are parallel");
}

Body parentOf(const Element &joint, const Scope &model) {
    const Element &parent = joint.required("parent");
    return parent.text == "world" ? nullptr : model.body(parent.text, parent);
}

}  // namespace

JointedBodies readJointedBodies(const Element &joint, const Scope &model) {
    const JointedBodies bodies{parentOf(joint, model),
                               model.body(joint.required("child").text, joint.required("child"))};
    if (bodies.parent == bodies.child)
        joint.fail("joins " + support::quote(bodies.child->attribute("name")) + " to itself");
    return bodies;
}

Joint readJoint(const Element &source, const Scope &model, const std::string &name, const Pose &modelPose,
                const Reading &reading) {
    Joint joint;
    joint.name = name;
    joint.place = source.place();
    joint.type = typeOf(source);
    joint.anchor = (modelPose * model.pose(source)).position;
    readAxes(source, model, modelPose, joint, reading);
    if (const Element *const physics = source.child("physics")) readPhysics(*physics, joint, reading);
    return joint;
}

}  // namespace worlds
