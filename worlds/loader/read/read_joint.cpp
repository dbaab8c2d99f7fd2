#include "loader/read/read_joint.h"

#include "loader/read/element_rules.h"
#include "loader/read/semantic_pose.h"

#include <ignition/math/Helpers.hh>
#include <sdf/JointAxis.hh>

#include <cmath>

namespace worlds {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
std::optional<JointType> toType(sdf::JointType type) {
    switch (type) {
        case sdf::JointType::REVOLUTE:
        case sdf::JointType::CONTINUOUS:
            return JointType::Revolute;
        case sdf::JointType::PRISMATIC:
            return JointType::Prismatic;
        case sdf::JointType::BALL:
            return JointType::Ball;
        case sdf::JointType::UNIVERSAL:
            return JointType::Universal;
        case sdf::JointType::REVOLUTE2:
            return JointType::Revolute2;
        case sdf::JointType::FIXED:
            return JointType::Fixed;
        default:  // checkElements has named it
            return std::nullopt;
    }
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

// SDF: negative means "no limit".
double limitOrNone(double value) { return value < 0 || value >= largestNumber ? infinity : value; }

// ODE measures angles between -π and π: a single stop beyond that would be reached from the wrong side.
void checkAngleLimits(const JointAxis &axis, const Place &place, const Reading &reading) {
    const bool unreachable = axis.lower < -IGN_PI && axis.upper > IGN_PI;
    const bool lowerTooFar = std::isfinite(axis.lower) && axis.lower < -IGN_PI;
    const bool upperTooFar = std::isfinite(axis.upper) && axis.upper > IGN_PI;
    if (!unreachable && (lowerTooFar || upperTooFar))
        reading.issues.unsupported(place, "one of two stops beyond half a turn");
}

void readLimits(const sdf::JointAxis &source, JointAxis &axis, const Place &place) {
    axis.lower = source.Lower() <= -largestNumber ? -infinity : source.Lower();
    axis.upper = source.Upper() >= largestNumber ? infinity : source.Upper();
    if (axis.lower > axis.upper)
        throw LoadError(LoadError::Kind::Value, place, "lower limit above upper limit");
    axis.maxForce = limitOrNone(source.Effort());
    axis.maxSpeed = limitOrNone(source.MaxVelocity());
}

JointAxis readAxis(const sdf::JointAxis &source, const ignition::math::Pose3d &modelPose,
                   const Place &place) {
    JointAxis axis;
    ignition::math::Vector3d inModel;
    const sdf::Errors errors = source.ResolveXyz(inModel, "__model__");
    if (!errors.empty()) throw LoadError(LoadError::Kind::Value, place, errors.front().Message());
    axis.direction = modelPose.Rot() * inModel;
    readLimits(source, axis, place);
    axis.friction = source.Friction();
    axis.damping = source.Damping();
    axis.springStiffness = source.SpringStiffness();
    axis.springReference = source.SpringReference();
    return axis;
}

std::optional<double> optionalNumber(const Parameters *element, const std::string &child) {
    if (!element || !element->child(child)) return std::nullopt;
    return element->child(child)->number();
}

void readOde(const Parameters &ode, Joint &joint, const Reading &reading) {
    joint.cfm = optionalNumber(&ode, "cfm");
    joint.erp = optionalNumber(&ode, "erp");
    if (joint.erp && joint.type != JointType::Ball && joint.type != JointType::Fixed) {
        reading.issues.unsupported(ode.child("erp")->place, "on a joint other than ball and fixed");
        joint.erp.reset();  // ODE takes it for these two alone
    }
    for (const char *const ofAnAxis : {"bounce", "fudge_factor", "max_force", "velocity", "limit"})
        if (const Parameters *child = ode.child(ofAnAxis); child && axisCount(joint.type) == 0)
            reading.issues.unsupported(child->place, "on a joint without an axis");
    joint.bounce = optionalNumber(&ode, "bounce");
    joint.fudgeFactor = optionalNumber(&ode, "fudge_factor");
    joint.motorForce = optionalNumber(&ode, "max_force");
    joint.motorSpeed = optionalNumber(&ode, "velocity");
    joint.stopCfm = optionalNumber(ode.child("limit"), "cfm");
    joint.stopErp = optionalNumber(ode.child("limit"), "erp");
    if (const Parameters *suspension = ode.child("suspension")) {
        if (joint.type != JointType::Revolute2)
            return reading.issues.unsupported(suspension->place, "on a joint other than revolute2");
        joint.suspensionCfm = optionalNumber(suspension, "cfm");
        joint.suspensionErp = optionalNumber(suspension, "erp");
    }
}

void readPhysics(const sdf::ElementPtr &element, Joint &joint, const Reading &reading) {
    if (!element->HasElement("physics")) return;
    const Parameters physics = toParameters(element->GetElement("physics"), reading.worldFile);
    const auto isTrue = [](const Parameters *flag) {
        return flag && (flag->text == "true" || flag->text == "1");
    };
    joint.feedback = isTrue(physics.child("provide_feedback"));
    if (const Parameters *ode = physics.child("ode")) {
        joint.feedback = joint.feedback || isTrue(ode->child("provide_feedback"));
        readOde(*ode, joint, reading);
    }
}

void readAxes(const sdf::Joint &source, const ignition::math::Pose3d &modelPose, Joint &joint,
              const Reading &reading) {
    const unsigned count = axisCount(joint.type);
    for (unsigned i = 0; i < 2; ++i) {
        const sdf::JointAxis *axis = source.Axis(i);
        const Place place = axis && axis->Element() ? reading.place(axis->Element()) : joint.place;
        if (i < count && !axis)
            throw LoadError(LoadError::Kind::Value, place, i ? "needs <axis2>" : "needs <axis>");
        if (i >= count && axis) reading.issues.unsupported(place, "on this type of joint");
        if (i >= count) continue;
        joint.axes.push_back(readAxis(*axis, modelPose, place));
        if (joint.type != JointType::Prismatic) checkAngleLimits(joint.axes.back(), place, reading);
    }
    if (joint.type == JointType::Revolute2 &&
        (std::isfinite(joint.axes[1].lower) || std::isfinite(joint.axes[1].upper)))
        reading.issues.unsupported(reading.place(source.Axis(1)->Element()), "limits of the second axis");
    if (count == 2 && joint.axes[0].direction.Cross(joint.axes[1].direction).Length() < 1e-6)
        throw LoadError(LoadError::Kind::Value, joint.place, "the two axes are parallel");
}

}  // namespace

std::optional<Joint> readJoint(const sdf::Joint &source, const std::string &name,
                               const ignition::math::Pose3d &modelPose, const LinkNumber &linkNumber,
                               const Reading &reading) {
    const std::optional<JointType> type = toType(source.Type());
    if (!type) return std::nullopt;

    Joint joint;
    joint.name = name;
    joint.place = reading.place(source.Element());
    joint.type = *type;
    std::string parent, child;
    sdf::Errors errors = source.ResolveParentLink(parent);
    const sdf::Errors childErrors = source.ResolveChildLink(child);
    errors.insert(errors.end(), childErrors.begin(), childErrors.end());
    if (!errors.empty()) throw LoadError(LoadError::Kind::Value, joint.place, errors.front().Message());
    joint.parent = linkNumber(parent);
    joint.child = linkNumber(child);
    joint.anchor = (modelPose * resolvePose(source.SemanticPose(), joint.place, "__model__")).Pos();
    readAxes(source, modelPose, joint, reading);
    readPhysics(source.Element(), joint, reading);
    return joint;
}

}  // namespace worlds
