// A drum that turns at a fixed speed with N by N by N cubes inside, which four ribs lift and drop.
//
// Facts: the scene washer (N = 20) of Box3D's benchmark, 30c67b5: sizes, density, friction, gravity, speed, step. Its panels are convex wedges, which
// are boxes here: ODE's collider of convex geoms does not find the shallowest way out of long panels, and pushes cubes out of the drum.
#include "scenes/catalogue.h"
#include "scenes/world_scene.h"

#include <cmath>

namespace scenes {

namespace {

constexpr int kPanels = 36, kPanelsPerRib = 9;
constexpr dReal kRib = 14, kInside = 16, kOutside = 18;  // m, radii
constexpr dReal kLength = 20, kHeight = 21;              // m, of the drum; of its axis above the ground
constexpr dReal kSpeed = 25 * kPi / 180;                 // rad/s
constexpr dReal kOverlap = kPi / 180;                    // rad, by which a panel reaches under its neighbours
constexpr dReal kSide = REAL(0.4);                       // m, of a cube; as much room between two
constexpr dReal kMass = 64;                              // kg, at 1000 kg/m³

class Washer final : public WorldScene {
public:
    explicit Washer(const SceneOptions &options) : WorldScene(options, kBox3DStepSize) {
        useBox3DDefaults();
        addGround();
        addDrum();
        const dReal corner = kSide * (1 - options.size);
        for (int i = 0; i < options.size; ++i)
            for (int j = 0; j < options.size; ++j)
                for (int k = 0; k < options.size; ++k)
                    addBox(Vector3{corner, corner, corner + kHeight} + 2 * kSide * Vector3{dReal(i), dReal(j), dReal(k)}, {kSide, kSide, kSide},
                           kMass);
    }

private:
    // The axis is y. Its parts overlap, and no two parts of one body are tested.
    void addDrum() {
        const dBodyID drum = add(dBodyCreate(world()));
        dBodySetPosition(drum, 0, 0, kHeight);
        dBodySetKinematic(drum);
        dBodySetAngularVel(drum, 0, kSpeed, 0);
        for (int panel = 0; panel < kPanels; ++panel) {
            const dReal half = kPi / kPanels, middle = (2 * panel + 1) * half;
            addPart(drum, middle, half + kOverlap, kInside, kOutside);
            if (panel % kPanelsPerRib == 0) addPart(drum, middle, half, kRib, kInside);
        }
    }

    // A box as thick as the part, as wide as a chord in its middle.
    void addPart(dBodyID drum, dReal middle, dReal halfAngle, dReal inner, dReal outer) {
        const dReal radius = (inner + outer) / 2;
        const dGeomID geom = dCreateBox(space(), outer - inner, kLength, 2 * radius * std::sin(halfAngle));
        dGeomSetBody(geom, drum);
        dMatrix3 rotation;
        dRFromAxisAndAngle(rotation, 0, 1, 0, -middle);
        dGeomSetOffsetRotation(geom, rotation);
        dGeomSetOffsetPosition(geom, radius * std::cos(middle), 0, radius * std::sin(middle));
        add(geom);
    }
};

}  // namespace

std::unique_ptr<Scene> makeWasher(const SceneOptions &options) { return std::make_unique<Washer>(options); }

}  // namespace scenes
