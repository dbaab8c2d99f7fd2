// Everything the loader takes from an SDF file, resolved to world coordinates: the data between reading
// (read/) and building (scene/, ODE). Lengths in m, masses in kg, times in s, angles in rad.
#pragma once

#include "loader/description/element.h"
#include "loader/description/geometry.h"
#include "loader/load_error.h"
#include "scenes/scene_options.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace worlds {

// Collision shapes, SI units, each in its own frame with z up.
struct Box {
    Vector3 size;
};
struct Sphere {
    double radius;
};
struct Cylinder {  // along z
    double radius, length;
};
struct Capsule {  // along z; the length goes without the caps
    double radius, length;
};
struct Plane {
    Vector3 normal;
};
struct TriangleMesh {
    std::vector<float> vertices;           // x y z of each
    std::vector<std::uint32_t> triangles;  // three vertex numbers each
};
struct HeightField {
    int columns = 0, rows = 0;    // samples along x and y, at least 2 each
    std::vector<double> heights;  // row by row, the first row at the largest y
    double width = 0, depth = 0;  // between the first and last sample along x and y
};

using Shape = std::variant<Box, Sphere, Cylinder, Capsule, Plane, TriangleMesh, HeightField>;

// How a collision shape behaves in contact: SDF's <surface>, in the terms of ODE.
struct Surface {
    double mu = 1, mu2 = 1;       // Coulomb friction along the first and second friction direction
    double slip1 = 0, slip2 = 0;  // m/(N·s), force-dependent slip
    std::optional<Vector3> frictionDirection;  // the first one, in the shape's frame,
    std::string frictionFrame;                 // or in that of this link of the same model

    double restitution = 0;
    double bounceThreshold = 100000;  // m/s, SDF's default: no bounce

    // Unset: the world's ERP and CFM hold for the contact.
    std::optional<double> softErp, softCfm;

    // Two shapes may touch when one's category matches the other's collide mask.
    unsigned short category = 0xffff, collide = 0xffff;
    bool makesContacts = true;  // else it touches nothing, whatever the masks
};

struct Collision {
    std::string name;
    Place place;
    Shape shape;
    Pose pose;  // in the link's frame
    Surface surface;
    int maxContacts = 0;  // contact joints for one pair at most
};

struct Mass {
    double mass = 1;  // kg
    Vector3 center;   // of mass, in the link's frame
    Matrix3 inertia;  // kg·m² about the centre of mass, along the link's axes
};

// A body with its collision shapes, or shapes that do not move.
struct Link {
    std::string name;       // "model::link", with every enclosing model
    int model = 0;          // number of the model that holds it
    Pose pose;              // of the link's frame, in the world
    bool isStatic = false;  // the rest is then without meaning, collisions excepted
    bool kinematic = false;
    bool gravity = true;
    bool autoDisable = true;
    bool selfCollide = false;
    std::optional<double> linearDamping, angularDamping;  // unset: the world's
    Mass mass;
    std::vector<Collision> collisions;
};

enum class JointType { Revolute, Prismatic, Ball, Universal, Revolute2, Fixed };

// Lengths in m and angles in rad; forces in N or N·m accordingly.
struct JointAxis {
    Vector3 direction;  // in the world, at the start
    double lower = -std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();
    double maxForce = std::numeric_limits<double>::infinity();  // of a motor
    double maxSpeed = std::numeric_limits<double>::infinity();  // of a motor
    double friction = 0;                                        // largest force that opposes any motion
    double damping = 0;                                         // force per speed
    double springStiffness = 0, springReference = 0;
};

// A joint between two links, or between a link and the world.
struct Joint {
    static constexpr int world = -1;  // in place of a link

    std::string name;  // "model::joint"
    Place place;
    JointType type = JointType::Fixed;
    int parent = world, child = world;  // numbers of links
    Vector3 anchor;                     // in the world, at the start
    std::vector<JointAxis> axes;        // 0, 1 or 2, as the type has degrees of freedom with an axis
    bool feedback = false;              // ODE keeps the joint's forces

    // ODE's joint parameters; unset: ODE's own defaults.
    std::optional<double> cfm, erp, stopCfm, stopErp, bounce, fudgeFactor;
    std::optional<double> suspensionCfm, suspensionErp;
    std::optional<double> motorForce, motorSpeed;  // of the first axis, from the start
};

// A body at rest for `idleTime` and `idleSteps` is no longer simulated until something touches it.
struct AutoDisable {
    double linearThreshold = 0.01;   // m/s
    double angularThreshold = 0.01;  // rad/s
    double idleTime = 0;             // s
    int idleSteps = 10;
    int averageSamples = 1;
};

// Share of a body's speed that ODE takes away at every step, above a threshold.
struct Damping {
    double linear = 0, angular = 0;
    double linearThreshold = 0, angularThreshold = 0;  // m/s, rad/s
};

struct Space {
    scenes::SpaceKind kind = scenes::SpaceKind::Simple;
    int minLevel = -3, maxLevel = 10;        // hash: cells of 2^level m
    Vector3 center, extents{100, 100, 100};  // quadtree, m
    int depth = 5;                           // quadtree
};

// Parameters of the world as a whole. SDF's defaults are the initial values here.
struct Physics {
    double stepSize = 0.001;  // s
    Vector3 gravity{0, 0, -9.8};
    scenes::Stepper stepper = scenes::Stepper::Quick;
    int iterations = 50;  // of the quick stepper
    double sor = 1.3;     // its over-relaxation
    double cfm = 0, erp = 0.2;
    double maxCorrectingSpeed = 100;  // m/s, of contacts
    double surfaceLayer = 0.001;      // m, depth at which contacts rest
    bool frictionPyramid = true;      // friction follows the normal force; false: a constant box

    int maxContacts = 20;         // contact joints for one pair of shapes; the deepest are kept
    int contactCandidates = 100;  // contacts asked of ODE for one pair

    Space space;
    Surface defaultSurface;
    std::optional<AutoDisable> autoDisable;  // unset: bodies never sleep
    std::optional<Damping> damping;
};

// A <plugin> of a model. Joint names in it are meant within that model.
struct ControllerDescription {
    std::string type;                           // the plugin's filename
    std::string model;                          // "outer::inner"
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
