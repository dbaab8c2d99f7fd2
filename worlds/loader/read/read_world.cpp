#include "loader/read/read_world.h"

#include "loader/control/controller_registry.h"
#include "loader/read/read_joint.h"
#include "loader/read/read_link.h"
#include "loader/read/read_physics.h"
#include "loader/read/semantic_pose.h"

#include <unordered_map>

namespace worlds {

namespace {

class WorldReader {
public:
    WorldReader(WorldDescription &world, const Reading &reading) : m_world(world), m_reading(reading) {}

    // `outer` is "outer::" for a model within a model.
    void model(const sdf::Model &model, const std::string &outer, const ignition::math::Pose3d &outerPose,
               bool outerStatic) {
        const std::string name = outer + model.Name();
        const ignition::math::Pose3d pose =
            outerPose * resolvePose(model.SemanticPose(), m_reading.place(model.Element()));
        const bool isStatic = outerStatic || model.Static();
        links(model, name, pose, isStatic);
        for (uint64_t i = 0; i < model.ModelCount(); ++i)
            this->model(*model.ModelByIndex(i), name + "::", pose, isStatic);
        if (isStatic) return;  // nothing for joints and controllers to move
        joints(model, name, pose);
        controllers(model, name);
    }

private:
    void links(const sdf::Model &model, const std::string &name, const ignition::math::Pose3d &pose,
               bool isStatic) {
        const int number = m_modelCount++;
        for (uint64_t i = 0; i < model.LinkCount(); ++i) {
            const sdf::Link &source = *model.LinkByIndex(i);
            Link link = readLink(source, model, name + "::" + source.Name(), pose, isStatic, m_reading);
            link.model = number;
            m_numbers[link.name] = static_cast<int>(m_world.links.size());
            m_world.links.push_back(std::move(link));
        }
    }

    void joints(const sdf::Model &model, const std::string &name, const ignition::math::Pose3d &pose) {
        const auto number = [&](const std::string &link) {
            return link == "world" ? Joint::world : m_numbers.at(name + "::" + link);
        };
        for (uint64_t i = 0; i < model.JointCount(); ++i) {
            const sdf::Joint &source = *model.JointByIndex(i);
            const std::string jointName = name + "::" + source.Name();
            if (std::optional<Joint> joint = readJoint(source, jointName, pose, number, m_reading))
                m_world.joints.push_back(std::move(*joint));
        }
    }

    void controllers(const sdf::Model &model, const std::string &name) {
        forEachWritten(model.Element(), [&](const sdf::ElementPtr &element) {
            if (element->GetName() != "plugin") return;
            Parameters parameters = toParameters(element, m_reading.worldFile);
            const std::string type = parameters.attribute("filename");
            if (!isControllerType(type)) return;
            parameters.limitNumbers(kMaxControllerNumber);
            m_world.controllers.push_back({type, name, std::move(parameters)});
        });
    }

    WorldDescription &m_world;
    const Reading &m_reading;
    std::unordered_map<std::string, int> m_numbers;  // of links, by name in the world
    int m_modelCount = 0;
};

}  // namespace

WorldDescription readWorld(const sdf::World &source, const std::string &worldFile,
                           const ResourceFinder &resources, const Issues &issues) {
    WorldDescription world;
    world.physics = readPhysics(source, worldFile);
    const Reading reading{worldFile, resources, issues, world.physics};
    WorldReader reader(world, reading);
    for (uint64_t i = 0; i < source.ModelCount(); ++i)
        reader.model(*source.ModelByIndex(i), "", ignition::math::Pose3d::Zero, false);
    return world;
}

}  // namespace worlds
