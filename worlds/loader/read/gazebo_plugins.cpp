#include "loader/read/gazebo_plugins.h"

#include <algorithm>
#include <map>

namespace worlds {

namespace {

using Effects = std::map<std::string, PluginEffect>;

constexpr PluginEffect kNothing = PluginEffect::MovesNothing, kAwaits = PluginEffect::AwaitsMessages;

// gz-sim-NAME-system of Gazebo. Left out, as they act without being told: buoyancy, lift-drag, hydrodynamics,
// wind-effects, wheel-slip, detachable-joint, controllers that hold a joint at a position, trajectory-follower and others.
const Effects &systems() {
    static const Effects effects = {
        {"acoustic-comms", kNothing},
        {"air-pressure", kNothing},
        {"air-speed", kNothing},
        {"altimeter", kNothing},
        {"camera-video-recorder", kNothing},
        {"collada-world-exporter", kNothing},
        {"comms-endpoint", kNothing},
        {"contact", kNothing},
        {"cpu-lidar", kNothing},
        {"dvl", kNothing},
        {"entity-semantics", kNothing},
        {"environment-preload", kNothing},
        {"environmental-sensor", kNothing},
        {"follow-actor", kNothing},
        {"forcetorque", kNothing},
        {"imu", kNothing},
        {"joint-state-publisher", kNothing},
        {"kinetic-energy-monitor", kNothing},
        {"label", kNothing},
        {"led-plugin", kNothing},
        {"linearbatteryplugin", kNothing},
        {"log", kNothing},
        {"log-video-recorder", kNothing},
        {"logical-camera", kNothing},
        {"logicalaudiosensorplugin", kNothing},
        {"magnetometer", kNothing},
        {"model-photo-shoot", kNothing},
        {"navsat", kNothing},
        {"odometry-publisher", kNothing},
        {"opticaltactileplugin", kNothing},
        {"particle-emitter", kNothing},
        {"particle-emitter2", kNothing},
        {"perfect-comms", kNothing},
        {"performer-detector", kNothing},
        {"physics", kNothing},
        {"pose-publisher", kNothing},
        {"rf-comms", kNothing},
        {"scene-broadcaster", kNothing},
        {"sensors", kNothing},
        {"thermal", kNothing},
        {"thermal-sensor", kNothing},
        {"touchplugin", kNothing},
        {"triggered-publisher", kNothing},
        {"user-commands", kNothing},
        {"websocket-server", kNothing},
        {"ackermann-steering", kAwaits},
        {"apply-joint-force", kAwaits},
        {"apply-link-wrench", kAwaits},
        {"breadcrumbs", kAwaits},
        {"diff-drive", kAwaits},
        {"drive-to-pose-controller", kAwaits},
        {"joint-controller", kAwaits},
        {"mecanum-drive", kAwaits},
        {"multicopter-control", kAwaits},
        {"multicopter-motor-model", kAwaits},
        {"thruster", kAwaits},
        {"track-controller", kAwaits},
        {"tracked-vehicle", kAwaits},
        {"velocity-control", kAwaits},
    };
    return effects;
}

// libNAME.so: of Gazebo classic, of ROS and of PX4.
const Effects &libraries() {
    static const Effects effects = {
        {"RealSensePlugin", kNothing},
        {"gazebo_barometer_plugin", kNothing},
        {"gazebo_gps_plugin", kNothing},
        {"gazebo_groundtruth_plugin", kNothing},
        {"gazebo_imu_plugin", kNothing},
        {"gazebo_magnetometer_plugin", kNothing},
        {"gazebo_multirotor_base_plugin", kNothing},
        {"gazebo_opticalflow_mockup_plugin", kNothing},
        {"gazebo_ros_factory", kNothing},
        {"gazebo_ros_imu", kNothing},
        {"gazebo_ros_imu_sensor", kNothing},
        {"gazebo_ros_init", kNothing},
        {"gazebo_ros_joint_state_publisher", kNothing},
        {"gazebo_ros_p3d", kNothing},
        {"gazebo_ros_state", kNothing},
        {"gazebo_vision_plugin", kNothing},
        {"rotors_gazebo_imu_plugin", kNothing},
        {"rotors_gazebo_multirotor_base_plugin", kNothing},
        {"rotors_gazebo_octomap_plugin", kNothing},
        {"DiffDrivePlugin", kAwaits},
        {"SkidSteerDrivePlugin", kAwaits},
        {"gazebo_mavlink_interface", kAwaits},
        {"gazebo_motor_model", kAwaits},
        {"gazebo_ros_diff_drive", kAwaits},
        {"gazebo_ros_force", kAwaits},
        {"gazebo_ros_planar_move", kAwaits},
        {"rotors_gazebo_mavlink_interface", kAwaits},
        {"rotors_gazebo_motor_model", kAwaits},
        {"rotors_gazebo_ros_interface_plugin", kAwaits},
    };
    return effects;
}

bool startsWith(const std::string &text, const std::string &begin) { return text.compare(0, begin.size(), begin) == 0; }

bool endsWith(const std::string &text, const std::string &end) {
    return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

bool cutBegin(std::string &text, const std::string &begin) {
    if (!startsWith(text, begin)) return false;
    text.erase(0, begin.size());
    return true;
}

bool cutEnd(std::string &text, const std::string &end) {
    if (!endsWith(text, end)) return false;
    text.resize(text.size() - end.size());
    return true;
}

// "gz-sim8-imu-system" becomes "imu". False for another name, which stays.
bool cutSystem(std::string &name) {
    std::string rest = name;
    if (!cutBegin(rest, "gz-sim") && !cutBegin(rest, "ignition-gazebo")) return false;
    rest.erase(0, rest.find_first_not_of("0123456789"));  // a major version
    if (!cutBegin(rest, "-") || !cutEnd(rest, "-system")) return false;
    name = rest;
    return true;
}

// Whether a plugin that waits for messages is told in its element how to begin.
bool actsAtOnce(const Element &plugin) {
    return std::any_of(plugin.children.begin(), plugin.children.end(), [](const Element &child) {
        return startsWith(child.name, "initial_") || child.name == "persistent";
    });
}

// The system that plays a log moves what the log says; the one that records has the same file.
bool playsALog(const Element &plugin) {
    return endsWith(plugin.attributeOrEmpty("name"), "LogPlayback");
}

}  // namespace

PluginEffect pluginEffect(const Element &plugin) {
    const std::string system = plugin.attributeOrEmpty("name");
    if (system == "gz::sim" || system == "ignition::gazebo") return PluginEffect::MovesNothing;  // levels: settings of Gazebo's
    std::string name = plugin.attributeOrEmpty("filename");
    const bool isLibrary = cutEnd(name, ".so");
    if (isLibrary) cutBegin(name, "lib");
    const bool isSystem = cutSystem(name);
    if (!isSystem && !isLibrary) return PluginEffect::Unknown;
    const Effects &effects = isSystem ? systems() : libraries();
    const auto known = effects.find(name);
    if (known == effects.end() || playsALog(plugin)) return PluginEffect::Unknown;
    return known->second == kAwaits && actsAtOnce(plugin) ? PluginEffect::Unknown : known->second;
}

std::string pluginsThat(PluginEffect effect) {
    std::string names;
    const auto add = [&](const Effects &effects, const std::string &begin, const std::string &end) {
        for (const auto &[name, known] : effects)
            if (known == effect) names += (names.empty() ? "`" : ", `") + begin + name + end + "`";
    };
    add(systems(), "", "");
    add(libraries(), "lib", ".so");
    return names;
}

}  // namespace worlds
