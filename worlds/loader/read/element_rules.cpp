#include "loader/read/element_rules.h"

#include "loader/control/controller_registry.h"

#include <limits>
#include <unordered_map>

namespace worlds {

namespace {

using Rules = std::vector<NamedRule>;

constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr double farthestStop = 1e9;  // m or rad, if it is on the other side

ElementRule numbers(int count, double least, double most) {
    return {Use::Read, Type::Numbers, count, least, most, Often::Once};
}
ElementRule whole(double least, double most) {
    return {Use::Read, Type::Whole, 1, least, most, Often::Once};
}
ElementRule limit(double least, double most = infinity) {
    return {Use::Read, Type::Limit, 1, least, most, Often::Once};
}
ElementRule choice(const std::vector<std::string> &choices) {
    return {Use::Read, Type::Choice, 0, 0, 0, Often::Once, choices};
}
ElementRule needingOneOf(const std::vector<std::string> &children) {
    return {Use::Read, Type::Group, 0, 0, 0, Often::Any, {}, {}, false, children};
}
ElementRule needing(const std::vector<std::string> &children, Often often = Often::Once) {
    return {Use::Read, Type::Group, 0, 0, 0, often, {}, children};
}

const ElementRule group, many{Use::Read, Type::Group, 0, 0, 0, Often::Any};
const ElementRule noPhysics{Use::NoPhysics, Type::Any, 0, 0, 0, Often::Any};
const ElementRule bySelf{Use::ReadBySelf, Type::Any, 0, 0, 0, Often::Any};
const ElementRule defaultOnly{Use::DefaultOnly, Type::Any};
const ElementRule text{Use::Read, Type::Text}, flag{Use::Read, Type::Flag}, pose{Use::Read, Type::Pose};
const ElementRule finite = numbers(1, -largestNumber, largestNumber);
const ElementRule vector = numbers(3, -largestNumber, largestNumber);
const ElementRule direction{Use::Read, Type::Direction, 3, -largestNumber, largestNumber};
const ElementRule notNegative = numbers(1, 0, largestNumber);
const ElementRule positive = numbers(1, smallestPositive, largestNumber);
const ElementRule length = numbers(1, 1e-9, largestNumber), size = numbers(3, 1e-9, largestNumber);
const ElementRule share = numbers(1, 0, 1);
const ElementRule count = whole(1, 0xffff);  // ODE counts contacts in 16 bits
const ElementRule mask = whole(0, 0xffff);
const ElementRule hashLevel = whole(-30, 30);  // cells of 2^level m

const Rules worldRules = {
    {"/sdf", group},
    {"/sdf/world", group},
    {"world/gravity", vector},
    {"world/physics", many},
    {"world/model", needingOneOf({"link", "model", "include"})},
    {"world/frame", many},
    {"world/frame/pose", pose},
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
    {"world/physics/max_step_size", numbers(1, 1e-9, 1e3)},
    {"world/physics/real_time_factor", noPhysics},
    {"world/physics/real_time_update_rate", noPhysics},
    {"world/physics/max_contacts", count},
    {"world/physics/dart", noPhysics},  // parameters of other engines
    {"world/physics/simbody", noPhysics},
    {"world/physics/bullet", noPhysics},
    {"world/physics/ode", group},
    {"world/physics/ode/solver", group},
    {"world/physics/ode/solver/type", choice({"world", "quick"})},
    {"world/physics/ode/solver/iters", whole(1, 1e6)},
    {"world/physics/ode/solver/sor", positive},
    {"world/physics/ode/solver/friction_model", choice({"pyramid_model", "box_model"})},
    {"world/physics/ode/solver/min_step_size", noPhysics},   // steps have one size
    {"world/physics/ode/solver/island_threads", noPhysics},  // threads are the library's affair
    {"world/physics/ode/solver/precon_iters", defaultOnly},  // the rest is in Gazebo's own ODE alone
    {"world/physics/ode/solver/thread_position_correction", defaultOnly},
    {"world/physics/ode/solver/use_dynamic_moi_rescaling", defaultOnly},
    {"world/physics/ode/constraints", group},
    {"world/physics/ode/constraints/cfm", notNegative},
    {"world/physics/ode/constraints/erp", share},
    {"world/physics/ode/constraints/contact_max_correcting_vel", limit(0)},
    {"world/physics/ode/constraints/contact_surface_layer", notNegative},
    {"world/physics/odemt:contact_candidates", count},
    {"world/physics/odemt:space", group},
    {"world/physics/odemt:space/min_level", hashLevel},
    {"world/physics/odemt:space/max_level", hashLevel},
    {"world/physics/odemt:space/center", vector},
    {"world/physics/odemt:space/extents", size},
    {"world/physics/odemt:space/depth", whole(0, 10)},  // 4^depth cells
    {"world/physics/odemt:auto_disable", group},
    {"world/physics/odemt:auto_disable/linear_threshold", notNegative},
    {"world/physics/odemt:auto_disable/angular_threshold", notNegative},
    {"world/physics/odemt:auto_disable/idle_time", notNegative},
    {"world/physics/odemt:auto_disable/idle_steps", whole(0, 1e9)},
    {"world/physics/odemt:auto_disable/average_samples", whole(1, 1000)},  // each body keeps as many
    {"world/physics/odemt:damping", group},
    {"world/physics/odemt:damping/linear", share},
    {"world/physics/odemt:damping/angular", share},
    {"world/physics/odemt:damping/linear_threshold", notNegative},
    {"world/physics/odemt:damping/angular_threshold", notNegative},
    {"world/physics/odemt:default_surface", group},
};

Rules includeRules(const std::string &include) {
    return {
        {include, needing({"uri"}, Often::Any)},
        {include + "/uri", text},
        {include + "/name", text},
        {include + "/pose", pose},
        {include + "/static", flag},
        {include + "/placement_frame", text},
        {include + "/plugin", bySelf},
    };
}

const Rules modelRules = {
    {"model/pose", pose},
    {"model/static", flag},
    {"model/self_collide", flag},
    {"model/allow_auto_disable", flag},
    {"model/enable_wind", defaultOnly},
    {"model/frame", many},
    {"model/frame/pose", pose},
    {"model/link", many},
    {"model/joint", needing({"parent", "child"}, Often::Any)},
    {"model/model", needingOneOf({"link", "model", "include"})},
    {"model/plugin", bySelf},
};

const Rules linkRules = {
    {"link/pose", pose},
    {"link/gravity", flag},
    {"link/self_collide", flag},
    {"link/kinematic", flag},
    {"link/enable_wind", defaultOnly},
    {"link/must_be_base_link", defaultOnly},
    {"link/velocity_decay", group},
    {"link/velocity_decay/linear", share},
    {"link/velocity_decay/angular", share},
    {"link/inertial", group},
    {"link/inertial/mass", positive},
    {"link/inertial/pose", pose},
    {"link/inertial/inertia", group},
    {"link/inertial/inertia/ixx", positive},
    {"link/inertial/inertia/iyy", positive},
    {"link/inertial/inertia/izz", positive},
    {"link/inertial/inertia/ixy", finite},
    {"link/inertial/inertia/ixz", finite},
    {"link/inertial/inertia/iyz", finite},
    {"link/collision", needing({"geometry"}, Often::Any)},
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
    {"collision/pose", pose},
    {"collision/laser_retro", noPhysics},
    {"collision/max_contacts", count},
    {"collision/geometry", {Use::Read, Type::Group, 0, 0, 0, Often::Once, {}, {}, true}},
    {"collision/geometry/empty", group},
    {"collision/geometry/box", needing({"size"})},
    {"collision/geometry/box/size", size},
    {"collision/geometry/sphere", needing({"radius"})},
    {"collision/geometry/sphere/radius", length},
    {"collision/geometry/cylinder", needing({"radius", "length"})},
    {"collision/geometry/cylinder/radius", length},
    {"collision/geometry/cylinder/length", length},
    {"collision/geometry/capsule", needing({"radius", "length"})},
    {"collision/geometry/capsule/radius", length},
    {"collision/geometry/capsule/length", length},
    {"collision/geometry/plane", group},
    {"collision/geometry/plane/normal", direction},
    {"collision/geometry/plane/size", noPhysics},  // drawn size; in collision a plane is infinite
    {"collision/geometry/mesh", needing({"uri"})},
    {"collision/geometry/mesh/uri", text},
    {"collision/geometry/mesh/scale", size},
    {"collision/geometry/heightmap", needing({"uri"})},
    {"collision/geometry/heightmap/uri", text},
    {"collision/geometry/heightmap/size", numbers(3, 1e-9, 1e9)},
    {"collision/geometry/heightmap/pos", vector},
    {"collision/geometry/heightmap/texture", noPhysics},
    {"collision/geometry/heightmap/blend", noPhysics},
    {"collision/geometry/heightmap/use_terrain_paging", noPhysics},
    {"collision/geometry/heightmap/sampling", defaultOnly},
};

const Rules surfaceRules = {
    {"collision/surface", group},
    {"collision/surface/bounce", group},
    {"collision/surface/bounce/restitution_coefficient", share},
    {"collision/surface/bounce/threshold", limit(0)},
    {"collision/surface/friction", group},
    {"collision/surface/friction/ode", group},
    {"collision/surface/friction/ode/mu", limit(0)},
    {"collision/surface/friction/ode/mu2", limit(0)},
    {"collision/surface/friction/ode/slip1", notNegative},
    {"collision/surface/friction/ode/slip2", notNegative},
    {"collision/surface/friction/ode/fdir1", vector},
    {"collision/surface/friction/bullet", noPhysics},
    {"collision/surface/contact", group},
    {"collision/surface/contact/collide_without_contact", defaultOnly},
    {"collision/surface/contact/collide_without_contact_bitmask", noPhysics},
    {"collision/surface/contact/collide_bitmask", mask},
    {"collision/surface/contact/category_bitmask", mask},
    {"collision/surface/contact/poissons_ratio", defaultOnly},
    {"collision/surface/contact/elastic_modulus", defaultOnly},
    {"collision/surface/contact/ode", group},
    {"collision/surface/contact/ode/soft_cfm", notNegative},
    {"collision/surface/contact/ode/soft_erp", share},
    {"collision/surface/contact/ode/kp", positive},
    {"collision/surface/contact/ode/kd", notNegative},
    {"collision/surface/contact/bullet", noPhysics},
    {"collision/surface/soft_contact", noPhysics},  // holds parameters of DART alone
};

Rules axisRules(const std::string &axis) {
    return {
        {axis, group},
        {axis + "/xyz", direction},
        {axis + "/dynamics", group},
        {axis + "/dynamics/damping", notNegative},
        {axis + "/dynamics/friction", notNegative},
        {axis + "/dynamics/spring_reference", finite},
        {axis + "/dynamics/spring_stiffness", notNegative},
        {axis + "/limit", group},
        {axis + "/limit/lower", limit(-infinity, farthestStop)},
        {axis + "/limit/upper", limit(-farthestStop)},
        {axis + "/limit/effort", limit(-infinity)},  // negative: no limit
        {axis + "/limit/velocity", limit(-infinity)},
        {axis + "/limit/stiffness", defaultOnly},
        {axis + "/limit/dissipation", defaultOnly},
    };
}

const Rules jointRules = {
    {"joint/pose", pose},
    {"joint/parent", text},
    {"joint/child", text},
    {"joint/sensor", noPhysics},
    {"joint/physics", group},
    {"joint/physics/simbody", noPhysics},
    {"joint/physics/provide_feedback", flag},
    {"joint/physics/ode", group},
    {"joint/physics/ode/provide_feedback", flag},
    {"joint/physics/ode/cfm_damping", defaultOnly},
    {"joint/physics/ode/implicit_spring_damper", defaultOnly},
    {"joint/physics/ode/fudge_factor", notNegative},
    {"joint/physics/ode/cfm", notNegative},
    {"joint/physics/ode/erp", share},
    {"joint/physics/ode/bounce", share},
    {"joint/physics/ode/max_force", notNegative},
    {"joint/physics/ode/velocity", finite},
    {"joint/physics/ode/limit", group},
    {"joint/physics/ode/limit/cfm", notNegative},
    {"joint/physics/ode/limit/erp", share},
    {"joint/physics/ode/suspension", group},
    {"joint/physics/ode/suspension/cfm", notNegative},
    {"joint/physics/ode/suspension/erp", share},
};

Rules allRules() {
    Rules all;
    for (const Rules &rules :
         {worldRules, includeRules("world/include"), physicsRules, modelRules, includeRules("model/include"),
          linkRules, collisionRules, surfaceRules, jointRules, axisRules("joint/axis"),
          axisRules("joint/axis2")})
        all.insert(all.end(), rules.begin(), rules.end());
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

const std::vector<NamedRule> &elementRules() {
    static const Rules rules = allRules();
    return rules;
}

const ElementRule *findElementRule(const std::string &path) {
    static const std::unordered_map<std::string, const ElementRule *> byPath = [] {
        std::unordered_map<std::string, const ElementRule *> all;
        for (const NamedRule &named : elementRules()) all.emplace(named.path, &named.rule);
        return all;
    }();
    const auto found = byPath.find(path);
    return found == byPath.end() ? nullptr : found->second;
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
        {"world/physics/odemt:space", "type", {"simple", "hash", "sap", "quadtree"}},
    };
    return rules;
}

const std::vector<std::string> &sdfVersions() {
    static const std::vector<std::string> versions = {"1.2", "1.3", "1.4", "1.5", "1.6", "1.7", "1.8", "1.9"};
    return versions;
}

}  // namespace worlds
