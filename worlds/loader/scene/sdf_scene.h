// A scene made of the world in an SDF file.
#pragma once

#include "scenes/scene.h"

#include <memory>
#include <string>
#include <vector>

namespace worlds {

struct WorldDescription;

class SdfScene : public scenes::Scene {
public:
    // Throws LoadError.
    explicit SdfScene(const WorldDescription &world);
    ~SdfScene() override;

    void control() override;
    void collide() override;
    void step() override;
    void finish() override;

    // Return names in the order of the inventory: "model::link", "model::joint", "model::link::collision".
    const std::vector<std::string> &bodyNames() const { return m_bodyNames; }
    const std::vector<std::string> &jointNames() const { return m_jointNames; }
    const std::vector<std::string> &geomNames() const { return m_geomNames; }

private:
    struct Parts;

    static void nearCallback(void *scene, dGeomID geom1, dGeomID geom2);
    void meet(dGeomID geom1, dGeomID geom2);

    void addLinks(const WorldDescription &world);
    void setFrictionFrames(const WorldDescription &world);
    void addJoints(const WorldDescription &world);
    void addControllers(const WorldDescription &world);

    std::unique_ptr<Parts> m_parts;
    std::vector<std::string> m_bodyNames, m_jointNames, m_geomNames;
};

}  // namespace worlds
