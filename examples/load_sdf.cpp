// Loads the boxes, spheres and planes of an SDF world with libsdformat, and drops them. (The loader of worlds/ in the repository knows
// joints, meshes, surfaces and controllers, too.) Usage: load_sdf WORLD.sdf. Prints where each model is after a second, in metres.
#include <ode/ode.h>

#include <cstdio>
#include <ignition/math/Pose3.hh>
#include <map>
#include <sdf/sdf.hh>
#include <string>

namespace {

struct Scene {
    dWorldID world = dWorldCreate();
    dSpaceID space = dHashSpaceCreate(nullptr);
    dJointGroupID contacts = dJointGroupCreate(0);
    std::map<std::string, dBodyID> bodies;  // by the names of models
};

// Null: of another shape than this program knows.
dGeomID makeGeom(dSpaceID space, const sdf::Geometry &shape) {
    if (const auto *const box = shape.BoxShape()) return dCreateBox(space, box->Size().X(), box->Size().Y(), box->Size().Z());
    if (const auto *const sphere = shape.SphereShape()) return dCreateSphere(space, sphere->Radius());
    if (const auto *const plane = shape.PlaneShape()) {
        const auto &normal = plane->Normal();
        return dCreatePlane(space, normal.X(), normal.Y(), normal.Z(), 0);
    }
    return nullptr;
}

void place(dGeomID geom, const ignition::math::Pose3d &pose) {
    if (dGeomGetClass(geom) == dPlaneClass) return;  // through the origin
    const dQuaternion rotation = {pose.Rot().W(), pose.Rot().X(), pose.Rot().Y(), pose.Rot().Z()};
    dGeomSetPosition(geom, pose.Pos().X(), pose.Pos().Y(), pose.Pos().Z());
    dGeomSetQuaternion(geom, rotation);
}

// A model of one link, with the pose of the model.
void addModel(Scene &scene, const sdf::Model &model) {
    const sdf::Link &link = *model.LinkByIndex(0);
    dBodyID body = nullptr;
    if (!model.Static()) {
        body = scene.bodies[model.Name()] = dBodyCreate(scene.world);
        const auto &inertia = link.Inertial().MassMatrix();
        dMass mass;
        dMassSetParameters(&mass, inertia.Mass(), 0, 0, 0, inertia.DiagonalMoments().X(), inertia.DiagonalMoments().Y(),
                           inertia.DiagonalMoments().Z(), inertia.OffDiagonalMoments().X(), inertia.OffDiagonalMoments().Y(),
                           inertia.OffDiagonalMoments().Z());
        dBodySetMass(body, &mass);
    }
    for (std::uint64_t i = 0; i < link.CollisionCount(); ++i) {
        const dGeomID geom = makeGeom(scene.space, *link.CollisionByIndex(i)->Geom());
        if (geom == nullptr) continue;
        if (body != nullptr) dGeomSetBody(geom, body);
        place(geom, model.RawPose());
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
    sdf::Root root;
    const sdf::Errors errors = argc == 2 ? root.Load(argv[1]) : sdf::Errors{{sdf::ErrorCode::FILE_READ, "usage: load_sdf WORLD.sdf"}};
    for (const sdf::Error &error : errors) std::fprintf(stderr, "%s\n", error.Message().c_str());
    const sdf::World *const world = errors.empty() ? root.WorldByIndex(0) : nullptr;
    if (world == nullptr) return 1;

    dInitODE2(0);
    dToggleODE_MT(dODE_MT_AUTO);
    Scene scene;
    dWorldSetGravity(scene.world, world->Gravity().X(), world->Gravity().Y(), world->Gravity().Z());
    for (std::uint64_t i = 0; i < world->ModelCount(); ++i) addModel(scene, *world->ModelByIndex(i));
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
