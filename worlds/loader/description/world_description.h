// Everything the loader takes from an SDF file, resolved to world coordinates: the data between
// reading (read/) and building (scene/, ODE).
#pragma once

#include "loader/description/element.h"
#include "loader/description/joint.h"
#include "loader/description/link.h"
#include "loader/description/physics.h"

#include <memory>
#include <string>
#include <vector>

namespace worlds {

// A <plugin> of a model. Joint names in it are meant within that model.
struct ControllerDescription {
    std::string type;   // the plugin's filename
    std::string model;  // "outer::inner"
    std::shared_ptr<const Element> parameters;  // with all that is around it
};

struct WorldDescription {
    Physics physics;
    std::vector<Link> links;
    std::vector<Joint> joints;
    std::vector<ControllerDescription> controllers;
    bool staticMeetsStatic = false;  // pairs of static shapes reach the near callback, which drops them
};

}  // namespace worlds
