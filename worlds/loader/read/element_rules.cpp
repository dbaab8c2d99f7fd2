#include "loader/read/element_rules.h"

#include "loader/control/controller_registry.h"

#include <unordered_map>

namespace worlds {

namespace {

using Rules = std::unordered_map<std::string, ElementRule>;

constexpr ElementRule read{}, bySelf{Use::ReadBySelf}, noPhysics{Use::NoPhysics};
constexpr ElementRule defaultOnly{Use::DefaultOnly};
constexpr ElementRule limit{Use::Read, Holds::Limit};
constexpr ElementRule notNegativeLimit{Use::Read, Holds::NotNegativeLimit};
constexpr ElementRule finite{Use::Read, Holds::Finite};
constexpr ElementRule notNegative{Use::Read, Holds::NotNegative}, positive{Use::Read, Holds::Positive};
constexpr ElementRule share{Use::Read, Holds::Share};

const Rules worldRules = {
    {"/sdf", read},
    {"/sdf/world", read},
    {"world/gravity", finite},
    {"world/physics", read},
    {"world/model", read},
    {"world/frame", read},
    {"world/frame/pose", finite},
    {"world/plugin", noPhysics},  // attributeRules() lets pass those alone that move nothing
    {"world/magnetic_field", noPhysics},
    {"world/atmosphere", noPhysics},
    {"world/wind", noPhysics},  // acts on links with <enable_wind> only
    {"world/gui", noPhysics},
    {"world/scene", noPhysics},
    {"world/light", noPhysics},
    {"world/audio", noPhysics},
    {"world/spherical_coordinates", noPhysics},
};

const Rules physicsRules = {
    {"world/physics/max_step_size", positive},
    {"world/physics/real_time_factor", noPhysics},
    {"world/physics/real_time_update_rate", noPhysics},
    {"world/physics/max_contacts", positive},
    {"world/physics/dart", noPhysics},  // parameters of other engines
    {"world/physics/simbody", noPhysics},
    {"world/physics/bullet", noPhysics},
    {"world/physics/ode", read},
    {"world/physics/ode/solver", read},
    {"world/physics/ode/solver/type", read},
    {"world/physics/ode/solver/iters", positive},
    {"world/physics/ode/solver/sor", positive},
    {"world/physics/ode/solver/friction_model", read},
    {"world/physics/ode/solver/min_step_size", noPhysics},   // steps have one size
    {"world/physics/ode/solver/island_threads", noPhysics},  // threads are the library's affair
    {"world/physics/ode/solver/precon_iters", defaultOnly},  // the rest is in Gazebo's own ODE alone
    {"world/physics/ode/solver/thread_position_correction", defaultOnly},
    {"world/physics/ode/solver/use_dynamic_moi_rescaling", defaultOnly},
    {"world/physics/ode/constraints", read},
    {"world/physics/ode/constraints/cfm", notNegative},
    {"world/physics/ode/constraints/erp", share},
    {"world/physics/ode/constraints/contact_max_correcting_vel", notNegativeLimit},
    {"world/physics/ode/constraints/contact_surface_layer", notNegative},
    {"world/physics/odemt:contact_candidates", bySelf},
    {"world/physics/odemt:space", bySelf},
    {"world/physics/odemt:auto_disable", bySelf},
    {"world/physics/odemt:damping", bySelf},
    {"world/physics/odemt:default_surface", read},
};

const Rules modelRules = {
    {"model/pose", finite},
    {"model/static", read},
    {"model/self_collide", read},
    {"model/allow_auto_disable", read},
    {"model/enable_wind", defaultOnly},
    {"model/frame", read},
    {"model/frame/pose", finite},
    {"model/link", read},
    {"model/joint", read},
    {"model/model", read},
    {"model/plugin", bySelf},
};

const Rules linkRules = {
    {"link/pose", finite},
    {"link/gravity", read},
    {"link/self_collide", read},
    {"link/kinematic", read},
    {"link/enable_wind", defaultOnly},
    {"link/must_be_base_link", defaultOnly},
    {"link/velocity_decay", read},
    {"link/velocity_decay/linear", share},
    {"link/velocity_decay/angular", share},
    {"link/inertial", read},
    {"link/inertial/mass", positive},
    {"link/inertial/pose", finite},
    {"link/inertial/inertia", read},
    {"link/inertial/inertia/ixx", positive},
    {"link/inertial/inertia/iyy", positive},
    {"link/inertial/inertia/izz", positive},
    {"link/inertial/inertia/ixy", finite},
    {"link/inertial/inertia/ixz", finite},
    {"link/inertial/inertia/iyz", finite},
    {"link/collision", read},
    {"link/visual", noPhysics},
    {"link/sensor", noPhysics},
    {"link/projector", noPhysics},
    {"link/audio_sink", noPhysics},
    {"link/audio_source", noPhysics},
    {"link/battery", noPhysics},
    {"link/light", noPhysics},
    {"link/particle_emitter", noPhysics},
};

const Rules collisionRules = {
    {"collision/pose", finite},
    {"collision/laser_retro", noPhysics},
    {"collision/max_contacts", positive},
    {"collision/geometry", read},
    {"collision/geometry/empty", read},
    {"collision/geometry/box", read},
    {"collision/geometry/box/size", positive},
    {"collision/geometry/sphere", read},
    {"collision/geometry/sphere/radius", positive},
    {"collision/geometry/cylinder", read},
    {"collision/geometry/cylinder/radius", positive},
    {"collision/geometry/cylinder/length", positive},
    {"collision/geometry/capsule", read},
    {"collision/geometry/capsule/radius", positive},
    {"collision/geometry/capsule/length", positive},
    {"collision/geometry/plane", read},
    {"collision/geometry/plane/normal", finite},
    {"collision/geometry/plane/size", noPhysics},  // drawn size; in collision a plane is infinite
    {"collision/geometry/mesh", read},
    {"collision/geometry/mesh/uri", read},
    {"collision/geometry/mesh/scale", positive},
    {"collision/geometry/heightmap", read},
    {"collision/geometry/heightmap/uri", read},
    {"collision/geometry/heightmap/size", positive},
    {"collision/geometry/heightmap/pos", finite},
    {"collision/geometry/heightmap/texture", noPhysics},
    {"collision/geometry/heightmap/blend", noPhysics},
    {"collision/geometry/heightmap/use_terrain_paging", noPhysics},
    {"collision/geometry/heightmap/sampling", defaultOnly},
};

const Rules surfaceRules = {
    {"collision/surface", read},
    {"collision/surface/bounce", read},
    {"collision/surface/bounce/restitution_coefficient", share},
    {"collision/surface/bounce/threshold", notNegativeLimit},
    {"collision/surface/friction", read},
    {"collision/surface/friction/ode", read},
    {"collision/surface/friction/ode/mu", notNegativeLimit},
    {"collision/surface/friction/ode/mu2", notNegativeLimit},
    {"collision/surface/friction/ode/slip1", notNegative},
    {"collision/surface/friction/ode/slip2", notNegative},
    {"collision/surface/friction/ode/fdir1", finite},
    {"collision/surface/friction/bullet", noPhysics},
    {"collision/surface/contact", read},
    {"collision/surface/contact/collide_without_contact", defaultOnly},
    {"collision/surface/contact/collide_without_contact_bitmask", noPhysics},
    {"collision/surface/contact/collide_bitmask", notNegative},
    {"collision/surface/contact/category_bitmask", notNegative},
    {"collision/surface/contact/poissons_ratio", defaultOnly},
    {"collision/surface/contact/elastic_modulus", defaultOnly},
    {"collision/surface/contact/ode", read},
    {"collision/surface/contact/ode/soft_cfm", notNegative},
    {"collision/surface/contact/ode/soft_erp", share},
    {"collision/surface/contact/ode/kp", positive},
    {"collision/surface/contact/ode/kd", notNegative},
    {"collision/surface/contact/bullet", noPhysics},
    {"collision/surface/soft_contact", noPhysics},  // holds parameters of DART alone
};

Rules axisRules(const std::string &axis) {
    return {
        {axis, read},
        {axis + "/xyz", finite},
        {axis + "/dynamics", read},
        {axis + "/dynamics/damping", notNegative},
        {axis + "/dynamics/friction", notNegative},
        {axis + "/dynamics/spring_reference", finite},
        {axis + "/dynamics/spring_stiffness", notNegative},
        {axis + "/limit", read},
        {axis + "/limit/lower", limit},
        {axis + "/limit/upper", limit},
        {axis + "/limit/effort", limit},  // negative: no limit
        {axis + "/limit/velocity", limit},
        {axis + "/limit/stiffness", defaultOnly},
        {axis + "/limit/dissipation", defaultOnly},
    };
}

const Rules jointRules = {
    {"joint/pose", finite},
    {"joint/parent", read},
    {"joint/child", read},
    {"joint/sensor", noPhysics},
    {"joint/physics", read},
    {"joint/physics/simbody", noPhysics},
    {"joint/physics/provide_feedback", read},
    {"joint/physics/ode", read},
    {"joint/physics/ode/provide_feedback", read},
    {"joint/physics/ode/cfm_damping", defaultOnly},
    {"joint/physics/ode/implicit_spring_damper", defaultOnly},
    {"joint/physics/ode/fudge_factor", notNegative},
    {"joint/physics/ode/cfm", notNegative},
    {"joint/physics/ode/erp", share},
    {"joint/physics/ode/bounce", share},
    {"joint/physics/ode/max_force", notNegative},
    {"joint/physics/ode/velocity", finite},
    {"joint/physics/ode/limit", read},
    {"joint/physics/ode/limit/cfm", notNegative},
    {"joint/physics/ode/limit/erp", share},
    {"joint/physics/ode/suspension", read},
    {"joint/physics/ode/suspension/cfm", notNegative},
    {"joint/physics/ode/suspension/erp", share},
};

Rules allRules() {
    Rules all;
    for (const Rules &rules : {worldRules, physicsRules, modelRules, linkRules, collisionRules, surfaceRules,
                               jointRules, axisRules("joint/axis"), axisRules("joint/axis2")})
        all.insert(rules.begin(), rules.end());
    return all;
}

// Systems of Gazebo that draw, record or talk to the user: a world that names them moves the same
// without them.
const std::vector<std::string> gazeboSystems = {
    "gz-sim-physics-system",
    "ignition-gazebo-physics-system",
    "gz-sim-user-commands-system",
    "ignition-gazebo-user-commands-system",
    "gz-sim-scene-broadcaster-system",
    "ignition-gazebo-scene-broadcaster-system",
    "gz-sim-sensors-system",
    "ignition-gazebo-sensors-system",
    "gz-sim-contact-system",
    "ignition-gazebo-contact-system",
    "gz-sim-imu-system",
    "ignition-gazebo-imu-system",
};

}  // namespace

const ElementRule *findElementRule(const std::string &path) {
    static const Rules rules = allRules();
    const auto found = rules.find(path);
    return found == rules.end() ? nullptr : &found->second;
}

std::string elementContext(const std::string &path) {
    if (path == "world/physics/odemt:default_surface") return "collision/surface";
    static const std::unordered_map<std::string, std::string> innermost = {
        {"/sdf/world", "world"}, {"world/model", "model"},        {"model/model", "model"},
        {"model/link", "link"},  {"link/collision", "collision"}, {"model/joint", "joint"}};
    const auto found = innermost.find(path);
    return found == innermost.end() ? path : found->second;
}

const std::vector<AttributeRule> &attributeRules() {
    static const std::vector<AttributeRule> rules = {
        {"world/physics", "type", {"ode"}},
        {"model/joint",
         "type",
         {"revolute", "continuous", "prismatic", "ball", "universal", "revolute2", "fixed"}},
        {"model/plugin", "filename", controllerTypes()},
        {"world/plugin", "filename", gazeboSystems},
    };
    return rules;
}

}  // namespace worlds
