// N solids dropped on one another, convex polyhedra and cylinders alternately: ODE gives all pairs of them to
// libccd. Sizes and poses are random: where faces or edges of two solids are exactly parallel, libccd may
// find no direction to part them in, and the contact gets a normal of length zero.
#include "scenes/catalogue.h"
#include "scenes/random_rotation.h"
#include "scenes/world_scene.h"

#include <cmath>

namespace scenes {

namespace {

constexpr dReal kSmallest = REAL(0.2), kLargest = REAL(0.5);  // m, width
constexpr dReal kMass = 20;                                   // kg
constexpr dReal kCell = REAL(0.75);      // m, holds the largest solid however it is turned
constexpr dReal kStepSize = REAL(0.01);  // s

class Convex final : public WorldScene {
public:
    explicit Convex(const SceneOptions &options) : WorldScene(options, kStepSize) {
        addGround();
        // Twice as high as wide: it collapses into a heap.
        const int columns = static_cast<int>(std::ceil(std::cbrt(options.size / 2.0)));
        for (int i = 0; i < options.size; ++i) {
            const int layer = i / (columns * columns), row = i / columns % columns, column = i % columns;
            const Vector3 position{kCell * column, kCell * row, kCell * (layer + REAL(0.6))};
            turnAtRandom(i % 2 ? addRandomCylinder(position) : addPolyhedron(position), m_random);
        }
    }

private:
    dBodyID addRandomCylinder(const Vector3 &position) {
        const dReal radius = width() / 2, length = width();
        return addCylinder(position, kAxisZ, radius, length, kMass);
    }

    dBodyID addPolyhedron(const Vector3 &position) {
        return addConvex(position, std::make_shared<Polyhedron>(randomPolyhedron()), kMass);
    }

    Polyhedron randomPolyhedron() {
        const auto kind = m_random.next() % 3;
        const dReal a = width(), b = width(), c = width();
        if (kind == 0) return Polyhedron::octahedron({a / 2, b / 2, c / 2});
        if (kind == 1) return Polyhedron::hexagonalPrism(a / 2, b);
        return Polyhedron::cutCube(a);
    }

    dReal width() { return m_random.between(kSmallest, kLargest); }

    Generator m_random{6};
};

}  // namespace

std::unique_ptr<Scene> makeConvex(const SceneOptions &options) { return std::make_unique<Convex>(options); }

}  // namespace scenes
