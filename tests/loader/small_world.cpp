#include "small_world.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace small_world {

const std::string physics = R"(
    <physics type="ode">
      <max_step_size>0.001</max_step_size>
      <ode>
        <solver><type>world</type></solver>
        <constraints>
          <cfm>1e-9</cfm><erp>0.2</erp>
          <contact_max_correcting_vel>inf</contact_max_correcting_vel>
          <contact_surface_layer>0</contact_surface_layer>
        </constraints>
      </ode>
    </physics>)";

const std::string ground = staticModel("floor", "0 0 0 0 0 0", "<plane><normal>0 0 1</normal></plane>");

std::string world(const std::string &inside) { return worldWith(physics, inside); }

std::string worldWith(const std::string &ownPhysics, const std::string &inside) {
    return "<?xml version=\"1.0\"?>\n<sdf version=\"1.9\"><world name=\"test\">" + ownPhysics + "\n" +
           inside + "</world></sdf>";
}

namespace {

std::string collision(const std::string &geometry, const std::string &surface) {
    return "<collision name=\"shape\"><geometry>" + geometry + "</geometry>" + surface + "</collision>";
}

}  // namespace

std::string linkOf1kg(const std::string &name, const std::string &pose, const std::string &inside) {
    return "<link name=\"" + name + "\"><pose>" + pose +
           "</pose><inertial><mass>1</mass>"
           "<inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz></inertia></inertial>" +
           inside + "</link>";
}

std::string model(const std::string &name, const std::string &pose, const std::string &geometry,
                  const std::string &surface) {
    return "<model name=\"" + name + "\"><pose>" + pose + "</pose>" +
           linkOf1kg("link", "0 0 0 0 0 0", collision(geometry, surface)) + "</model>\n";
}

std::string staticModel(const std::string &name, const std::string &pose, const std::string &geometry) {
    return "<model name=\"" + name + "\"><static>true</static><pose>" + pose + "</pose><link name=\"link\">" +
           collision(geometry, "") + "</link></model>\n";
}

std::string box(double x, double y, double z) {
    return "<box><size>" + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) +
           "</size></box>";
}

std::string sphere(double radius) {
    return "<sphere><radius>" + std::to_string(radius) + "</radius></sphere>";
}

std::unique_ptr<worlds::SdfScene> load(const std::string &sdf, const worlds::LoadOptions &options) {
    return worlds::loadWorldText(sdf, "test.sdf", options);
}

Loaded loadWithWarnings(const std::string &sdf, bool ignoreUnsupported) {
    Loaded loaded;
    worlds::LoadOptions options;
    options.ignoreUnsupported = ignoreUnsupported;
    options.warnings = &loaded.warnings;
    loaded.scene = load(sdf, options);
    return loaded;
}

namespace {

template <class Handle>
Handle find(const std::vector<Handle> &handles, const std::vector<std::string> &names,
            const std::string &name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) throw std::out_of_range("the scene has no " + name);
    return handles.at(static_cast<std::size_t>(found - names.begin()));
}

Vector3 toVector(const dReal *v) { return Vector3{v[0], v[1], v[2]}; }

}  // namespace

dBodyID body(const worlds::SdfScene &scene, const std::string &name) {
    return find(scene.inventory().bodies, scene.bodyNames(), name);
}
dJointID joint(const worlds::SdfScene &scene, const std::string &name) {
    return find(scene.inventory().joints, scene.jointNames(), name);
}
dGeomID geom(const worlds::SdfScene &scene, const std::string &name) {
    return find(scene.inventory().geoms, scene.geomNames(), name);
}

dMass massOf(dBodyID body) {
    dMass mass;
    dBodyGetMass(body, &mass);
    return mass;
}

Vector3 position(dBodyID body) { return toVector(dBodyGetPosition(body)); }
Vector3 velocity(dBodyID body) { return toVector(dBodyGetLinearVel(body)); }
Vector3 spin(dBodyID body) { return toVector(dBodyGetAngularVel(body)); }

void run(worlds::SdfScene &scene, int frames) {
    for (int i = 0; i < frames; ++i) scene.frame();
}

void runFor(worlds::SdfScene &scene, double seconds) {
    run(scene, static_cast<int>(std::lround(seconds / scene.stepSize())));
}

bool isFinite(const worlds::SdfScene &scene) {
    return std::all_of(scene.inventory().bodies.begin(), scene.inventory().bodies.end(), [](dBodyID body) {
        return position(body).isFinite() && velocity(body).isFinite() && spin(body).isFinite();
    });
}

std::size_t staticGeoms(const worlds::SdfScene &scene) {
    const auto &geoms = scene.inventory().geoms;
    return static_cast<std::size_t>(
        std::count_if(geoms.begin(), geoms.end(), [](dGeomID geom) { return !dGeomGetBody(geom); }));
}

double totalMass(const worlds::SdfScene &scene, const std::string &model) {
    double total = 0;
    for (std::size_t i = 0; i < scene.bodyNames().size(); ++i) {
        if (scene.bodyNames()[i].compare(0, model.size() + 2, model + "::") != 0) continue;
        total += massOf(scene.inventory().bodies[i]).mass;
    }
    return total;
}

void expectError(const std::string &sdf, worlds::LoadError::Kind kind,
                 const std::vector<std::string> &parts) {
    try {
        load(sdf);
        ADD_FAILURE() << "loaded without an error:\n" << sdf;
    } catch (const worlds::LoadError &error) {
        EXPECT_EQ(static_cast<int>(error.kind()), static_cast<int>(kind)) << error.what();
        for (const std::string &part : parts)
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos)
                << "\"" << error.what() << "\" does not say \"" << part << "\"";
    }
}

}  // namespace small_world
