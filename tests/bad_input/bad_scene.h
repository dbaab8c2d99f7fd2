// Objects of every kind for calls with bad arguments.
#pragma once

#include <ode/ode.h>

#include <string>
#include <vector>

namespace bad_input {

struct BadScene {
    BadScene();

    // The one that a function is for, by its name: dGeomSphereGetRadius a sphere.
    std::size_t geomFor(const std::string &function) const;
    std::size_t jointFor(const std::string &function) const;

    dWorldID world;
    std::vector<dSpaceID> spaces;
    std::vector<dGeomID> geoms;  // by kGeomNames
    std::vector<dJointID> joints;
    std::vector<dBodyID> bodies;
    dJointGroupID group;
    dTriMeshDataID mesh, emptyMesh;
    dHeightfieldDataID heights, emptyHeights;
    dMass mass;
};

extern BadScene *scene;

}  // namespace bad_input
