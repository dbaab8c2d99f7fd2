// A link: a body with its collision shapes, or shapes that do not move.
#pragma once

#include "loader/description/geometry.h"
#include "loader/description/shape.h"
#include "loader/description/surface.h"
#include "loader/load_error.h"

#include <optional>
#include <string>
#include <vector>

namespace worlds {

struct Collision {
    std::string name;
    Place place;
    Shape shape;
    Pose pose;  // in the link's frame
    Surface surface;
    int maxContacts = 0;  // contact joints for one pair at most
};

struct Mass {
    double mass = 1;                   // kg
    Vector3 center;   // of mass, in the link's frame
    Matrix3 inertia;  // kg·m² about the centre of mass, along the link's axes
};

struct Link {
    std::string name;             // "model::link", with every enclosing model
    int model = 0;                // number of the model that holds it
    Pose pose;  // of the link's frame, in the world
    bool isStatic = false;        // the rest is then without meaning, collisions excepted
    bool kinematic = false;
    bool gravity = true;
    bool autoDisable = true;
    bool selfCollide = false;
    std::optional<double> linearDamping, angularDamping;  // unset: the world's
    Mass mass;
    std::vector<Collision> collisions;
};

}  // namespace worlds
