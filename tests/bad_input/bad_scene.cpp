#include "bad_scene.h"

#include "bad_values.h"

#include <cstdint>
#include <cstring>
#include <map>

namespace bad_input {

namespace {

// Parts of the names of functions, in the order of what BadScene makes.
const char *const kGeomNames[] = {"Sphere", "Box",    "Capsule", "Cylinder",    "Plane",
                                  "Ray",    "Convex", "TriMesh", "Heightfield", "Transform"};
const char *const kJointNames[] = {"Ball",    "Hinge",  "Slider", "Universal",   "Hinge2", "PR",
                                   "PU",      "Piston", "Fixed",  "Null",        "AMotor", "LMotor",
                                   "Plane2D", "DBall",  "DHinge", "Transmission"};

// The longest that is part of the function's name, or the first.
template <std::size_t count>
std::size_t longestIn(const std::string &function, const char *const (&names)[count]) {
    std::size_t best = 0, length = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::string name = names[i];
        if (function.find(name) == std::string::npos || name.size() <= length) continue;
        best = i;
        length = name.size();
    }
    return best;
}

void addGeoms(BadScene &scene) {
    static const dReal planes[] = {1, 0, 0, 1, -1, 0, 0, 1, 0, 1, 0, 1, 0, -1, 0, 1, 0, 0, 1, 1, 0, 0, -1, 1};
    static const dReal points[] = {1, 1, 1,  -1, 1, 1,  1, -1, 1,  -1, -1, 1,
                                   1, 1, -1, -1, 1, -1, 1, -1, -1, -1, -1, -1};
    static const unsigned polygons[] = {4, 0, 2, 6, 4, 4, 1, 5, 7, 3, 4, 0, 4, 5, 1,
                                        4, 2, 3, 7, 6, 4, 0, 1, 3, 2, 4, 4, 6, 7, 5};
    static const float vertices[] = {-1, -1, 0, 1, -1, 0, 0, 1, 0, 0, 0, 1};
    static const dTriIndex indices[] = {0, 1, 2, 0, 1, 3, 1, 2, 3, 2, 0, 3};
    static const dReal samples[9] = {0, 1, 0, 1, 2, 1, 0, 1, 0};
    scene.mesh = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildSingle(scene.mesh, vertices, 3 * sizeof(float), 4, indices, 12,
                                3 * sizeof(dTriIndex));
    scene.emptyMesh = dGeomTriMeshDataCreate();
    scene.heights = dGeomHeightfieldDataCreate();
    dGeomHeightfieldDataBuildDouble(scene.heights, samples, 1, 4, 4, 3, 3, 1, 0, 1, 0);
    scene.emptyHeights = dGeomHeightfieldDataCreate();
    const dSpaceID space = scene.spaces[1];
    const dGeomID transform = dCreateGeomTransform(space);
    dGeomTransformSetGeom(transform, dCreateSphere(nullptr, 1));
    scene.geoms = {dCreateSphere(space, 1),
                   dCreateBox(space, 1, 1, 1),
                   dCreateCapsule(space, 1, 1),
                   dCreateCylinder(space, 1, 1),
                   dCreatePlane(space, 0, 0, 1, 0),
                   dCreateRay(space, 1),
                   dCreateConvex(space, planes, 6, points, 8, polygons),
                   dCreateTriMesh(space, scene.mesh, nullptr, nullptr, nullptr),
                   dCreateHeightfield(space, scene.heights, 1),
                   transform};
    for (std::size_t i = 0; i < scene.geoms.size(); ++i)
        if (i != 4) dGeomSetPosition(scene.geoms[i], 3 * static_cast<dReal>(i), 0, 5);
    dGeomSetBody(scene.geoms[0], scene.bodies[0]);
    dGeomSetBody(scene.geoms[1], scene.bodies[1]);
}

void addJoints(BadScene &scene) {
    using Create = dJointID (*)(dWorldID, dJointGroupID);
    for (const Create create :
         {dJointCreateBall, dJointCreateHinge, dJointCreateSlider, dJointCreateUniversal, dJointCreateHinge2,
          dJointCreatePR, dJointCreatePU, dJointCreatePiston, dJointCreateFixed, dJointCreateNull,
          dJointCreateAMotor, dJointCreateLMotor, dJointCreatePlane2D, dJointCreateDBall, dJointCreateDHinge,
          dJointCreateTransmission}) {
        scene.joints.push_back(create(scene.world, nullptr));
        const bool isForOneBody = create == dJointCreatePlane2D;
        dJointAttach(scene.joints.back(), scene.bodies[0], isForOneBody ? nullptr : scene.bodies[1]);
    }
}

}  // namespace

BadScene *scene = nullptr;

double *blockOfDoubles(double value) {
    static std::map<std::uint64_t, std::vector<double>> blocks;  // by the bits
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    std::vector<double> &block = blocks[bits];
    if (block.empty()) block.assign(kBlock / sizeof(double), value);
    return block.data();
}

BadScene::BadScene() : world(dWorldCreate()), group(dJointGroupCreate(0)) {
    const dVector3 centre{0, 0, 0}, extents{10, 10, 10};
    spaces = {dSimpleSpaceCreate(nullptr), dHashSpaceCreate(nullptr),
              dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ),
              dQuadTreeSpaceCreate(nullptr, centre, extents, 2)};
    for (int i = 0; i < 3; ++i) {
        bodies.push_back(dBodyCreate(world));
        dBodySetPosition(bodies.back(), 1.5 * i, 0, 5);
    }
    dMassSetSphere(&mass, 1, 1);
    addGeoms(*this);
    addJoints(*this);
}

std::size_t BadScene::geomFor(const std::string &function) const { return longestIn(function, kGeomNames); }
std::size_t BadScene::jointFor(const std::string &function) const { return longestIn(function, kJointNames); }

}  // namespace bad_input
