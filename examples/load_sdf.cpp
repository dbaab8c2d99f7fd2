// Loads the boxes, spheres and planes of an SDF world with TinyXML-2, and drops them. (The loader of worlds/ in the repository knows
// joints, frames, meshes, surfaces and controllers, too.) Usage: load_sdf WORLD.sdf. Prints where each model is after a second, in metres.
#include <ode/ode.h>
#include <tinyxml2.h>

#include <array>
#include <cstdio>
#include <map>
#include <sstream>
#include <string>

namespace {

using tinyxml2::XMLElement;

struct Scene {
    dWorldID world = dWorldCreate();
    dSpaceID space = dHashSpaceCreate(nullptr);
    dJointGroupID contacts = dJointGroupCreate(0);
    std::map<std::string, dBodyID> bodies;  // by the names of models
};

// The numbers of the element at the end of a path; `otherwise` where there is none.
template <std::size_t count>
std::array<double, count> numbers(const XMLElement *from, std::initializer_list<const char *> path, std::array<double, count> otherwise) {
    for (const char *name : path) from = from != nullptr ? from->FirstChildElement(name) : nullptr;
    if (from == nullptr || from->GetText() == nullptr) return otherwise;
    std::istringstream text(from->GetText());
    for (double &number : otherwise) text >> number;
    return otherwise;
}

// Null: of another shape than this program knows.
dGeomID makeGeom(dSpaceID space, const XMLElement &geometry) {
    if (geometry.FirstChildElement("box") != nullptr) {
        const auto size = numbers<3>(&geometry, {"box", "size"}, {1, 1, 1});
        return dCreateBox(space, size[0], size[1], size[2]);
    }
    if (geometry.FirstChildElement("sphere") != nullptr) return dCreateSphere(space, numbers<1>(&geometry, {"sphere", "radius"}, {1})[0]);
    if (geometry.FirstChildElement("plane") != nullptr) {
        const auto normal = numbers<3>(&geometry, {"plane", "normal"}, {0, 0, 1});
        return dCreatePlane(space, normal[0], normal[1], normal[2], 0);
    }
    return nullptr;
}

// Roll, pitch and yaw turn about the fixed axes x, y and z, in this order.
void place(dGeomID geom, const std::array<double, 6> &pose) {
    if (dGeomGetClass(geom) == dPlaneClass) return;  // through the origin
    dQuaternion roll, pitch, yaw, both, all;
    dQFromAxisAndAngle(roll, 1, 0, 0, pose[3]);
    dQFromAxisAndAngle(pitch, 0, 1, 0, pose[4]);
    dQFromAxisAndAngle(yaw, 0, 0, 1, pose[5]);
    dQMultiply0(both, pitch, roll);
    dQMultiply0(all, yaw, both);
    dGeomSetPosition(geom, pose[0], pose[1], pose[2]);
    dGeomSetQuaternion(geom, all);
}

// A model of one link, with the pose of the model.
void addModel(Scene &scene, const XMLElement &model) {
    const XMLElement *const link = model.FirstChildElement("link");
    bool isStatic = false;
    if (const XMLElement *const flag = model.FirstChildElement("static")) flag->QueryBoolText(&isStatic);
    dBodyID body = nullptr;
    if (!isStatic) {
        body = scene.bodies[model.Attribute("name")] = dBodyCreate(scene.world);
        const auto moment = [&](const char *name, double otherwise) { return numbers<1>(link, {"inertial", "inertia", name}, {otherwise})[0]; };
        dMass mass;
        dMassSetParameters(&mass, numbers<1>(link, {"inertial", "mass"}, {1})[0], 0, 0, 0, moment("ixx", 1), moment("iyy", 1), moment("izz", 1),
                           moment("ixy", 0), moment("ixz", 0), moment("iyz", 0));
        dBodySetMass(body, &mass);
    }
    for (const XMLElement *shape = link->FirstChildElement("collision"); shape != nullptr; shape = shape->NextSiblingElement("collision")) {
        const dGeomID geom = makeGeom(scene.space, *shape->FirstChildElement("geometry"));
        if (geom == nullptr) continue;
        if (body != nullptr) dGeomSetBody(geom, body);
        place(geom, numbers<6>(&model, {"pose"}, {}));
    }
}

void collide(void *data, dGeomID geom1, dGeomID geom2) {
    const auto *const scene = static_cast<const Scene *>(data);
    dContact contacts[8];
    const int count = dCollide(geom1, geom2, 8, &contacts[0].geom, sizeof(dContact));
    for (int i = 0; i < count; ++i) {
        contacts[i].surface.mode = dContactApprox1;
        contacts[i].surface.mu = 1;
        dJointAttach(dJointCreateContact(scene->world, scene->contacts, &contacts[i]), dGeomGetBody(geom1), dGeomGetBody(geom2));
    }
}

}  // namespace

int main(int argc, char **argv) {
    tinyxml2::XMLDocument document;
    if (argc == 2) document.LoadFile(argv[1]);
    const XMLElement *const sdf = document.FirstChildElement("sdf"), *const world = sdf != nullptr ? sdf->FirstChildElement("world") : nullptr;
    if (world == nullptr) return std::fprintf(stderr, "%s\n", document.Error() ? document.ErrorStr() : "usage: load_sdf WORLD.sdf"), 1;

    dInitODE2(0);
    dToggleODE_MT(dODE_MT_AUTO);
    Scene scene;
    const auto gravity = numbers<3>(world, {"gravity"}, {0, 0, -9.8});
    dWorldSetGravity(scene.world, gravity[0], gravity[1], gravity[2]);
    for (const XMLElement *model = world->FirstChildElement("model"); model != nullptr; model = model->NextSiblingElement("model"))
        addModel(scene, *model);
    for (int step = 0; step < 200; ++step) {
        dSpaceCollide(scene.space, &scene, collide);
        dWorldQuickStep(scene.world, 0.005);
        dJointGroupEmpty(scene.contacts);
    }
    for (const auto &[name, body] : scene.bodies) {
        const dReal *const position = dBodyGetPosition(body);
        std::printf("%s: %.4f %.4f %.4f\n", name.c_str(), position[0], position[1], position[2]);
    }
    dCloseODE();
}
