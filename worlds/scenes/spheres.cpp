// N balls of several sizes poured into an open box with four walls.
#include "scenes/catalogue.h"
#include "scenes/generator.h"
#include "scenes/world_scene.h"

#include <cmath>

namespace scenes {

namespace {

constexpr dReal kSmallest = REAL(0.05), kLargest = REAL(0.1);  // m, radius
constexpr dReal kDensity = 900;                                // kg/m³, rubber
constexpr dReal kCell = REAL(0.22);                            // m
constexpr dReal kStepSize = REAL(0.005);                       // s

class Spheres final : public WorldScene {
public:
    explicit Spheres(const SceneOptions &options) : WorldScene(options, kStepSize) {
        const int columns = static_cast<int>(std::ceil(std::cbrt(options.size)));
        addGround();
        const dReal width = kCell * columns;
        addWalls(width, 0, width + 1);  // hold all balls at once
        Generator random(3);
        for (int i = 0; i < options.size; ++i) {
            const int layer = i / (columns * columns), row = i / columns % columns, column = i % columns;
            const dReal radius = random.between(kSmallest, kLargest);
            const Vector3 corner{kCell * (column + REAL(0.5)), kCell * (row + REAL(0.5)),
                                 kCell * (layer + 1)};
            const Vector3 jitter{random.between(REAL(-0.01), REAL(0.01)),
                                 random.between(REAL(-0.01), REAL(0.01)), 0};
            addSphere(corner + jitter, radius, kDensity * REAL(4.18879) * radius * radius * radius);
        }
    }
};

}  // namespace

std::unique_ptr<Scene> makeSpheres(const SceneOptions &options) { return std::make_unique<Spheres>(options); }

}  // namespace scenes
