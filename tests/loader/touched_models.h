// Which models have touched which.
#pragma once

#include "small_world.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace small_world {

class TouchedModels : public scenes::Observer {
public:
    explicit TouchedModels(const worlds::SdfScene &scene) {
        for (std::size_t i = 0; i < scene.geomNames().size(); ++i) {
            const std::string &name = scene.geomNames()[i];
            m_models[scene.inventory().geoms[i]] = name.substr(0, name.find("::"));
        }
    }

    void contact(const dContact &contact) override {
        pairs.insert(std::minmax(m_models.at(contact.geom.g1), m_models.at(contact.geom.g2)));
    }

    std::set<std::pair<std::string, std::string>> pairs;

private:
    std::map<dGeomID, std::string> m_models;
};

}  // namespace small_world
