// N layers of convex rocks: dropped into a walled yard that a column sweeps, or on the ground, where they collapse into a heap.
//
// Facts: the scenes junkyard (N = 24 layers of 21 by 21 rocks of 10 corners) and convex_pile (N = 80 layers of 8 by 8 rocks of 32 corners) of Box3D's
// benchmark, 30c67b5: sizes, density, friction, gravity, step. Corners of the latter are random there and here, from other generators.
#include "scenes/catalogue.h"
#include "scenes/generator.h"
#include "scenes/world_scene.h"

#include <cmath>

namespace scenes {

namespace {

constexpr dReal kDensity = 1000;  // kg/m³

// Corners spread evenly over a ball: a Fibonacci lattice.
std::vector<Vector3> latticeOnBall(int count, dReal radius) {
    const dReal turn = 4 * kPi / (1 + std::sqrt(REAL(5.0)));  // rad, from corner to corner: the golden ratio of a turn
    std::vector<Vector3> corners;
    for (int i = 0; i < count; ++i) {
        const dReal z = 1 - (2 * i + REAL(1.0)) / count, r = std::sqrt(1 - z * z);
        corners.push_back(radius * Vector3{r * std::cos(turn * i), r * std::sin(turn * i), z});
    }
    return corners;
}

std::vector<Vector3> randomOnBall(int count, dReal radius, Generator &random) {
    std::vector<Vector3> corners;
    while (static_cast<int>(corners.size()) < count) {
        const Vector3 v{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
        const dReal square = v.x * v.x + v.y * v.y + v.z * v.z;
        if (square > REAL(0.01) && square <= 1) corners.push_back(radius / std::sqrt(square) * v);
    }
    return corners;
}

class Rocks : public WorldScene {
protected:
    Rocks(const SceneOptions &options, const std::vector<Vector3> &corners)
        : WorldScene(options, kBox3DStepSize), m_rock(std::make_shared<Polyhedron>(Polyhedron::hullOf(corners))) {
        useBox3DDefaults();
        addGround();
    }

    void addRock(const Vector3 &at) { addConvex(at, m_rock, kDensity * m_rock->volume()); }

private:
    const std::shared_ptr<Polyhedron> m_rock;
};

class Junkyard final : public Rocks {
public:
    explicit Junkyard(const SceneOptions &options) : Rocks(options, latticeOnBall(kCorners, kRockRadius)) {
        for (const dReal side : {-kYard, kYard}) {
            addStaticBox({side, 0, kWallHeight / 2}, {2, 2 * kYard, kWallHeight});
            addStaticBox({0, side, kWallHeight / 2}, {2 * kYard, 2, kWallHeight});
        }
        for (int layer = 0; layer < options.size; ++layer)
            for (int i = 0; i < kSide; ++i)
                for (int j = 0; j < kSide; ++j)
                    addRock({kPitch * (i - kSide / 2), kPitch * (j - kSide / 2), kPitch * layer + kDrop});
        m_column = addCylinder({kCourse, 0, kColumnHeight / 2}, kAxisZ, kColumnRadius, kColumnHeight, 1);
        dBodySetKinematic(m_column);
    }

    // The column moves on a circle, without turning.
    void control() override {
        const dReal angle = -kSpeed * static_cast<dReal>(time());
        dBodySetLinearVel(m_column, kCourse * kSpeed * std::sin(angle), -kCourse * kSpeed * std::cos(angle), 0);
    }

private:
    static constexpr int kCorners = 10, kSide = 21;
    static constexpr dReal kRockRadius = REAL(1.5), kPitch = 4, kDrop = 25;        // m
    static constexpr dReal kYard = 50, kWallHeight = 16;                           // m, half the width of the yard
    static constexpr dReal kColumnRadius = 4, kColumnHeight = 24, kCourse = 35;    // m
    static constexpr dReal kSpeed = 6 * kPi / 180;                                 // rad/s

    dBodyID m_column;
};

class ConvexPile final : public Rocks {
public:
    explicit ConvexPile(const SceneOptions &options) : Rocks(options, corners()) {
        for (int layer = 0; layer < options.size; ++layer)
            for (int i = 0; i < kSide; ++i)
                for (int j = 0; j < kSide; ++j)
                    addRock({2 * kRadius * (i - kSide / 2), 2 * kRadius * (j - kSide / 2), kRadius + 2 * kRadius * layer});
    }

private:
    static constexpr int kCorners = 32, kSide = 8;
    static constexpr dReal kRadius = 2;  // m

    static std::vector<Vector3> corners() {
        Generator random(42);
        return randomOnBall(kCorners, kRadius, random);
    }
};

}  // namespace

std::unique_ptr<Scene> makeJunkyard(const SceneOptions &options) { return std::make_unique<Junkyard>(options); }

std::unique_ptr<Scene> makeConvexPile(const SceneOptions &options) { return std::make_unique<ConvexPile>(options); }

}  // namespace scenes
