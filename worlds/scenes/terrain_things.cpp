// N boxes, balls, capsules and cylinders of everyday sizes on hilly ground, two layers of them dropped: some
// lie where they fell, some on one another, some roll down into the valleys. The ground is one geom that all
// of them collide: a triangle mesh, or a height field of the same shape.
#include "scenes/catalogue.h"
#include "scenes/random_rotation.h"
#include "scenes/terrain.h"
#include "scenes/world_scene.h"

#include <cmath>

namespace scenes {

namespace {

constexpr dReal kSmallest = REAL(0.2), kLargest = REAL(0.5);     // m, sides, lengths and diameters of balls
constexpr dReal kThinnest = REAL(0.08), kThickest = REAL(0.15);  // m, radii of capsules and cylinders
constexpr dReal kDensity = 400;                                  // kg/m³
constexpr dReal kReach = REAL(0.44);    // m, farthest corner of the largest box from its middle
constexpr dReal kSpacing = 2 * kReach;  // m: nothing touches at the start
constexpr dReal kMargin = 1;            // m of ground around all
constexpr dReal kPitch = REAL(0.5);     // m between samples of the ground
// ODE's height field now and then misses the contact of a ball for some frames: without a limit, finding it
// again throws the ball into the air.
constexpr dReal kFastestCorrection = 1;  // m/s
constexpr dReal kStepSize = REAL(0.01);  // s

using AddGround = dGeomID (Terrain::*)(WorldScene &) const;

class TerrainThings final : public WorldScene {
public:
    TerrainThings(const SceneOptions &options, AddGround addGround) : WorldScene(options, kStepSize) {
        const int columns = static_cast<int>(std::ceil(std::sqrt(options.size / 2.0)));
        const Terrain terrain(kSpacing * columns + 2 * kMargin, kPitch);
        (terrain.*addGround)(*this);
        addWalls(terrain.width(), -2, 4);  // what rolls does not fall off the edge
        dWorldSetContactMaxCorrectingVel(world(), kFastestCorrection);
        for (int i = 0; i < options.size; ++i) {
            const int layer = i / (columns * columns), row = i / columns % columns, column = i % columns;
            addThing(kMargin + kSpacing * (column + REAL(0.5)), kMargin + kSpacing * (row + REAL(0.5)),
                     layer);
        }
    }

private:
    void addThing(dReal x, dReal y, int layer) {
        // The ground under its farthest corner may be higher than under its middle.
        const dReal clear = kReach * (1 + Terrain::kSteepest);
        const Vector3 position{x, y, Terrain::height(x, y) + clear + kSpacing * layer};
        const auto kind = m_random.next() % 4;
        turnAtRandom(kind == 0   ? addRandomBox(position)
                     : kind == 1 ? addBall(position)
                     : kind == 2 ? addRandomCapsule(position)
                                 : addRandomCylinder(position),
                     m_random);
    }

    dBodyID addRandomBox(const Vector3 &position) {
        const dReal x = side(), y = side(), z = side();
        return addBox(position, {x, y, z}, kDensity * x * y * z);
    }

    dBodyID addBall(const Vector3 &position) {
        const dReal radius = side() / 2;
        return addSphere(position, radius, kDensity * ballVolume(radius));
    }

    dBodyID addRandomCapsule(const Vector3 &position) {
        const dReal radius = thickness(), length = side() / 2;
        const dReal volume = kPi * radius * radius * length + ballVolume(radius);
        return addCapsule(position, kAxisZ, radius, length, kDensity * volume);
    }

    dBodyID addRandomCylinder(const Vector3 &position) {
        const dReal radius = thickness(), length = side();
        return addCylinder(position, kAxisZ, radius, length, kDensity * kPi * radius * radius * length);
    }

    static dReal ballVolume(dReal radius) { return 4 * kPi / 3 * radius * radius * radius; }
    dReal side() { return m_random.between(kSmallest, kLargest); }
    dReal thickness() { return m_random.between(kThinnest, kThickest); }

    Generator m_random{5};
};

}  // namespace

std::unique_ptr<Scene> makeThingsOnMesh(const SceneOptions &options) {
    return std::make_unique<TerrainThings>(options, &Terrain::addMesh);
}

std::unique_ptr<Scene> makeThingsOnHeightField(const SceneOptions &options) {
    return std::make_unique<TerrainThings>(options, &Terrain::addHeightField);
}

}  // namespace scenes
