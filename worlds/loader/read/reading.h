// What the readers of models, links, shapes and joints share.
#pragma once

#include "loader/description/world_description.h"
#include "loader/read/element_path.h"
#include "loader/read/issues.h"
#include "loader/read/resource_finder.h"

namespace worlds {

struct Reading {
    const std::string &worldFile;
    const ResourceFinder &resources;
    const Issues &issues;
    const Physics &physics;

    Place place(const sdf::ElementPtr &element) const { return placeOf(element, worldFile); }
};

}  // namespace worlds
