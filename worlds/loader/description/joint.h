// A joint between two links, or between a link and the world.
#pragma once

#include "loader/description/geometry.h"
#include "loader/load_error.h"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace worlds {

enum class JointType { Revolute, Prismatic, Ball, Universal, Revolute2, Fixed };

// Lengths in m and angles in rad; forces in N or N·m accordingly.
struct JointAxis {
    Vector3 direction;  // in the world, at the start
    double lower = -std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();
    double maxForce = std::numeric_limits<double>::infinity();  // of a motor
    double maxSpeed = std::numeric_limits<double>::infinity();  // of a motor
    double friction = 0;                                        // largest force that opposes any motion
    double damping = 0;                                         // force per speed
    double springStiffness = 0, springReference = 0;
};

struct Joint {
    static constexpr int world = -1;  // in place of a link

    std::string name;  // "model::joint"
    Place place;
    JointType type = JointType::Fixed;
    int parent = world, child = world;  // numbers of links
    Vector3 anchor;    // in the world, at the start
    std::vector<JointAxis> axes;        // 0, 1 or 2, as the type has degrees of freedom with an axis
    bool feedback = false;              // ODE keeps the joint's forces

    // ODE's joint parameters; unset: ODE's own defaults.
    std::optional<double> cfm, erp, stopCfm, stopErp, bounce, fudgeFactor;
    std::optional<double> suspensionCfm, suspensionErp;
    std::optional<double> motorForce, motorSpeed;  // of the first axis, from the start
};

}  // namespace worlds
