#include "loader/read/element_rules.h"

#include "loader/read/gazebo_plugins.h"
#include "loader/read/value_check.h"
#include "support/text.h"

#include <algorithm>
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
ElementRule whole(double least, double most) { return {Use::Read, Type::Whole, 1, least, most, Often::Once}; }
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

ElementRule defaultOnly(const std::string &usual) {
    ElementRule rule{Use::DefaultOnly, Type::Any};
    rule.usual = usual;
    return rule;
}
// Another value than the default is left aside with a warning.
ElementRule defaultBut(const std::string &usual, const std::string &note) {
    ElementRule rule = defaultOnly(usual);
    rule.note = note;
    return rule;
}
ElementRule noPhysicsBut(const std::string &note) {
    ElementRule rule{Use::NoPhysics, Type::Any, 0, 0, 0, Often::Any};
    rule.note = note;
    return rule;
}
ElementRule until(int version, ElementRule rule) {
    rule.until = version;
    return rule;
}

const ElementRule group, many{Use::Read, Type::Group, 0, 0, 0, Often::Any};
const ElementRule noPhysics{Use::NoPhysics, Type::Any, 0, 0, 0, Often::Any};
const ElementRule bySelf{Use::ReadBySelf, Type::Any, 0, 0, 0, Often::Any};
const ElementRule text{Use::Read, Type::Text}, flag{Use::Read, Type::Flag}, pose{Use::Read, Type::Pose};
const ElementRule finite = numbers(1, -largestNumber, largestNumber);
const ElementRule vector = numbers(3, -largestNumber, largestNumber);
const ElementRule direction{Use::Read, Type::Direction, 3, -largestNumber, largestNumber};
const ElementRule notNegative = numbers(1, 0, largestNumber);
const ElementRule positive = numbers(1, smallestPositive, largestNumber);
const ElementRule length = numbers(1, 1e-9, largestNumber), size = numbers(3, 1e-9, largestNumber);
const ElementRule share = numbers(1, 0, 1);
const ElementRule stepSize = numbers(1, 1e-9, 1e3);
const ElementRule count = whole(1, 0xffff);  // ODE counts contacts in 16 bits
const ElementRule mask{Use::Read, Type::Mask, 1, 0, 0xffff};
const ElementRule hashLevel = whole(-30, 30);  // cells of 2^level m

const Rules worldRules = {
    {"/sdf", group},
    {"/sdf/world", group},
    {"world/gravity", vector},
    {"world/physics", many},
    {"world/model", needingOneOf({"link", "model", "include"})},
    {"world/frame", many},
    {"world/frame/pose", pose},
    {"world/plugin", noPhysics},  // gazebo_plugins.h lets pass those alone that move nothing
    {"world/magnetic_field", noPhysics},
    {"world/atmosphere", noPhysics},
    {"world/wind", noPhysics},  // acts on links with <enable_wind> only
    {"world/gui", noPhysics},
    {"world/scene", noPhysics},
    {"world/light", noPhysics},
    {"world/actor", noPhysics},  // animated; it touches nothing
    {"world/audio", noPhysics},
    {"world/road", noPhysics},  // drawn; it has no collision
    {"world/gz:policies", noPhysics},
    {"world/state", noPhysicsBut("models start where <model> says, as in Gazebo Sim")},
    {"world/spherical_coordinates", noPhysics},
};

const std::string ofGazebosSolver = "the solver of Gazebo's own ODE alone has it";

const Rules physicsRules = {
    {"world/physics/max_step_size", stepSize},
    {"world/physics/gravity", until(5, vector)},
    {"world/physics/magnetic_field", until(5, noPhysics)},
    {"world/physics/update_rate", until(3, noPhysics)},
    {"world/physics/real_time_factor", noPhysics},
    {"world/physics/real_time_update_rate", noPhysics},
    {"world/physics/max_contacts", count},
    {"world/physics/dart", noPhysics},  // parameters of other engines
    {"world/physics/simbody", noPhysics},
    {"world/physics/bullet", noPhysics},
    {"world/physics/ode", group},
    {"world/physics/ode/solver", group},
    {"world/physics/ode/solver/type", choice({"world", "quick"})},
    {"world/physics/ode/solver/dt", until(3, stepSize)},
    {"world/physics/ode/solver/iters", whole(1, 1e6)},
    {"world/physics/ode/solver/sor", positive},
    {"world/physics/ode/solver/friction_model", choice({"pyramid_model", "box_model"})},
    {"world/physics/ode/solver/min_step_size", noPhysics},        // steps have one size
    {"world/physics/ode/solver/island_threads", noPhysics},       // threads are the library's affair
    {"world/physics/ode/solver/precon_iters", defaultBut("0", ofGazebosSolver)},
    {"world/physics/ode/solver/thread_position_correction", defaultBut("false", ofGazebosSolver)},
    {"world/physics/ode/solver/use_dynamic_moi_rescaling", defaultBut("false", ofGazebosSolver)},
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
    {"model/enable_wind", defaultOnly("false")},
    {"model/gz:semantics", noPhysics},
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
    {"link/enable_wind", defaultOnly("false")},
    {"link/must_be_base_link", defaultOnly("false")},
    {"link/velocity_decay", group},
    {"link/velocity_decay/linear", share},
    {"link/velocity_decay/angular", share},
    {"link/inertial", group},
    {"link/inertial/mass", positive},
    {"link/inertial/density", positive},
    {"link/inertial/auto_inertia_params", noPhysics},  // of a calculation of one's own in Gazebo
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

// A size that is missing is SDF's default: 1 m, of a capsule's radius 0.5 m.
const Rules collisionRules = {
    {"collision/pose", pose},
    {"collision/laser_retro", noPhysics},
    {"collision/max_contacts", whole(0, 0xffff)},
    {"collision/density", positive},
    {"collision/auto_inertia_params", noPhysics},
    {"collision/geometry", {Use::Read, Type::Group, 0, 0, 0, Often::Once, {}, {}, true}},
    {"collision/geometry/empty", group},
    {"collision/geometry/box", group},
    {"collision/geometry/box/size", size},
    {"collision/geometry/sphere", group},
    {"collision/geometry/sphere/radius", length},
    {"collision/geometry/cylinder", group},
    {"collision/geometry/cylinder/radius", length},
    {"collision/geometry/cylinder/length", length},
    {"collision/geometry/capsule", group},
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
    {"collision/geometry/heightmap/sampling", defaultOnly("1")},
};

const Rules surfaceRules = {
    {"collision/surface", group},
    {"collision/surface/bounce", group},
    {"collision/surface/bounce/restitution_coefficient", share},
    {"collision/surface/bounce/threshold", limit(0)},
    {"collision/surface/friction", group},
    {"collision/surface/friction/ode", group},
    {"collision/surface/friction/ode/mu", limit(-infinity)},  // negative: no limit, as in Gazebo
    {"collision/surface/friction/ode/mu2", limit(-infinity)},
    {"collision/surface/friction/ode/slip1", notNegative},
    {"collision/surface/friction/ode/slip2", notNegative},
    {"collision/surface/friction/ode/fdir1", vector},
    {"collision/surface/friction/bullet", noPhysics},
    {"collision/surface/friction/torsional", group},  // ODE has none; without a radius it does nothing
    {"collision/surface/friction/torsional/coefficient", notNegative},
    {"collision/surface/friction/torsional/use_patch_radius", flag},
    {"collision/surface/friction/torsional/patch_radius", defaultOnly("0")},
    {"collision/surface/friction/torsional/surface_radius", defaultOnly("0")},
    {"collision/surface/friction/torsional/ode", group},
    {"collision/surface/friction/torsional/ode/slip", defaultOnly("0")},
    {"collision/surface/contact", group},
    {"collision/surface/contact/collide_without_contact", flag},
    {"collision/surface/contact/collide_without_contact_bitmask", noPhysics},
    {"collision/surface/contact/collide_bitmask", mask},
    {"collision/surface/contact/category_bitmask", mask},
    {"collision/surface/contact/poissons_ratio", noPhysics},  // used with an elastic modulus alone
    {"collision/surface/contact/elastic_modulus", defaultOnly("-1")},
    {"collision/surface/contact/ode", group},
    {"collision/surface/contact/ode/soft_cfm", notNegative},
    {"collision/surface/contact/ode/soft_erp", share},
    {"collision/surface/contact/ode/kp", positive},
    {"collision/surface/contact/ode/kd", notNegative},
    {"collision/surface/contact/ode/max_vel",
     defaultBut("0.01", "ODE has one for all contacts, <contact_max_correcting_vel>")},
    {"collision/surface/contact/ode/min_depth", defaultBut("0", "ODE has one for all contacts, <contact_surface_layer>")},
    {"collision/surface/contact/bullet", noPhysics},
    {"collision/surface/soft_contact", noPhysics},  // holds parameters of DART alone
};

Rules axisRules(const std::string &axis) {
    return {
        {axis, group},
        {axis + "/xyz", direction},
        {axis + "/use_parent_model_frame", until(6, flag)},
        {axis + "/initial_position", until(8, defaultOnly("0"))},
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
        {axis + "/limit/stiffness", defaultOnly("1e8")},
        {axis + "/limit/dissipation", defaultOnly("1")},
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
    {"joint/physics/ode/cfm_damping", noPhysics},  // how Gazebo integrates damping and springs, not what they are
    {"joint/physics/ode/implicit_spring_damper", noPhysics},
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
    for (const Rules &rules : {worldRules, includeRules("world/include"), physicsRules, modelRules,
                               includeRules("model/include"), linkRules, collisionRules, surfaceRules,
                               jointRules, axisRules("joint/axis"), axisRules("joint/axis2")})
        all.insert(all.end(), rules.begin(), rules.end());
    return all;
}

std::vector<std::string> versionNames() {
    std::vector<std::string> names;
    for (int version = oldestVersion; version <= newestVersion; ++version)
        names.push_back(versionName(version));
    return names;
}

}  // namespace

const std::vector<NamedRule> &elementRules() {
    static const Rules rules = allRules();
    return rules;
}

const ElementRule *findElementRule(const std::string &path, int version) {
    static const std::unordered_map<std::string, const ElementRule *> byPath = [] {
        std::unordered_map<std::string, const ElementRule *> all;
        for (const NamedRule &named : elementRules()) all.emplace(named.path, &named.rule);
        return all;
    }();
    const auto found = byPath.find(path);
    return found == byPath.end() || found->second->until < version ? nullptr : found->second;
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
        {"/sdf", "version", true, versionNames()},
        {"/sdf/world", "name", true},
        {"world/physics", "name"},
        {"world/physics", "default"},
        // Gazebo takes its own choice for an engine that it does not know, and we for every one.
        {"world/physics", "type", true},
        {"world/physics/odemt:space", "type", true, {"simple", "hash", "sap", "quadtree"}},
        {"world/frame", "name", true},
        {"world/frame", "attached_to"},
        {"world/model", "name", true},
        {"world/model", "canonical_link"},
        {"world/model", "placement_frame"},
        {"world/plugin", "name"},
        {"world/plugin", "filename", true},
        {"model/frame", "name", true},
        {"model/frame", "attached_to"},
        {"model/model", "name", true},
        {"model/model", "canonical_link"},
        {"model/model", "placement_frame"},
        {"model/include", "merge"},
        {"model/link", "name", true},
        {"model/joint", "name", true},
        {"model/joint",
         "type",
         true,
         {"revolute", "continuous", "prismatic", "ball", "universal", "revolute2", "fixed"}},
        {"model/plugin", "name", true},
        {"model/plugin", "filename", true},
        {"link/inertial", "auto", false, {"true", "false", "1", "0"}, 11},
        {"link/collision", "name", true},
        {"collision/surface/friction/ode/fdir1", "gz:expressed_in"},
        {"collision/surface/friction/ode/fdir1", "ignition:expressed_in"},
        {"joint/axis/xyz", "expressed_in", false, {}, 7},
        {"joint/axis2/xyz", "expressed_in", false, {}, 7},
    };
    return rules;
}

std::vector<const AttributeRule *> attributeRulesOf(const std::string &path) {
    static const std::unordered_map<std::string, std::vector<const AttributeRule *>> byPath = [] {
        std::unordered_map<std::string, std::vector<const AttributeRule *>> all;
        for (const AttributeRule &rule : attributeRules()) all[rule.path].push_back(&rule);
        return all;
    }();
    const auto found = byPath.find(path);
    return found == byPath.end() ? std::vector<const AttributeRule *>() : found->second;
}

std::string versionName(int version) { return "1." + std::to_string(version); }

std::optional<int> versionNamed(const std::string &name) {
    for (int version = oldestVersion; version <= newestVersion; ++version)
        if (name == versionName(version)) return version;
    return std::nullopt;
}

namespace {

std::string holds(const ElementRule &rule) {
    switch (rule.use) {
        case Use::Read:
            return describe(rule);
        case Use::ReadBySelf:
            return "a controller (README.md)";
        case Use::NoPhysics:
            return rule.note.empty() ? "left aside" : "left aside with a warning: " + rule.note;
        case Use::DefaultOnly:
            break;
    }
    if (!rule.note.empty()) return rule.usual + ", SDF's default; else left aside with a warning: " + rule.note;
    return rule.usual + ", SDF's default, only";
}

std::string code(const std::string &text) { return "`" + text + "`"; }

}  // namespace

std::string elementDocs() {
    std::string text =
        "# Elements\n\n"
        "Made from the table in `loader/read/element_rules.cpp`, by which worlds are checked; a test "
        "compares.\n"
        "Any other element or attribute is an error, and so is any other value, and text beside elements. Of several "
        "elements\n"
        "where one may be the first one counts, with a warning; of those in `odemt:` they are an error. An element that is "
        "missing\n"
        "has SDF's default. Versions " +
        versionName(oldestVersion) + " to " + versionName(newestVersion) +
        ".\n\nPaths begin at the innermost world, model, link, joint or collision.\n\n"
        "| Element | Times | Holds |\n|---|---|---|\n";
    for (const NamedRule &named : elementRules())
        text += "| " + code(named.path) + " | " + (named.rule.often == Often::Once ? "0..1" : "0..n") +
                " | " + holds(named.rule) +
                (named.rule.until < newestVersion ? "; up to version " + versionName(named.rule.until) : "") +
                " |\n";
    text += "\n| Attribute | Times | One of |\n|---|---|---|\n";
    for (const AttributeRule &rule : attributeRules())
        text += "| " + code(rule.path + " " + rule.attribute) + " | " + (rule.isNeeded ? "1" : "0..1") +
                " | " + (rule.values.empty() ? "any" : support::join(rule.values, ", ")) +
                (rule.since > oldestVersion ? "; from version " + versionName(rule.since) : "") + " |\n";
    return text +
           "\nPoses have `relative_to`, `rotation_format` (euler_rpy, quat_xyzw) and `degrees`; up to "
           "version 1.6 "
           "`frame` instead of `relative_to`.\n"
           "Attributes with a colon in their name are left aside.\n"
           "\n## Plugins of Gazebo\n\n"
           "No program of a plugin is run. Controllers of ours are in [README.md](README.md). Of others, by their file's "
           "name "
           "(`gz-sim-NAME-system`,\n"
           "`ignition-gazebo-NAME-system`, both also as `lib….so`):\n\n"
           "* They move nothing, and are left aside: " +
           pluginsThat(PluginEffect::MovesNothing) +
           ".\n* They move something only when they are sent messages, and are left aside with a warning, unless they are "
           "told how to begin (`initial_…`, `persistent`). A drive of Gazebo holds its wheels until then; here they are "
           "free: " +
           pluginsThat(PluginEffect::AwaitsMessages) + ".\n* Any other one may move something, and is not supported.\n";
}

}  // namespace worlds
