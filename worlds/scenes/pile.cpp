// N boxes of several sizes dropped on one another: few large islands, many contacts a body.
#include "scenes/catalogue.h"
#include "scenes/random_rotation.h"
#include "scenes/world_scene.h"

#include <cmath>

namespace scenes {

namespace {

constexpr dReal kSmallest = REAL(0.2), kLargest = REAL(0.5);  // m, side
constexpr dReal kDensity = 500;                               // kg/m³, wood
constexpr dReal kCell = REAL(0.95);                           // m, holds the largest box however it is turned
constexpr dReal kStepSize = REAL(0.01);                       // s

class Pile final : public WorldScene {
public:
    explicit Pile(const SceneOptions &options) : WorldScene(options, kStepSize) {
        addGround();
        Generator random(2);
        // Twice as high as wide: it collapses into a heap.
        const int columns = static_cast<int>(std::ceil(std::cbrt(options.size / 2.0)));
        for (int i = 0; i < options.size; ++i) {
            const int layer = i / (columns * columns), row = i / columns % columns, column = i % columns;
            addTurnedBox({kCell * column, kCell * row, kCell * (layer + REAL(0.6))}, random);
        }
    }

private:
    void addTurnedBox(const Vector3 &position, Generator &random) {
        const Vector3 sides{random.between(kSmallest, kLargest), random.between(kSmallest, kLargest),
                            random.between(kSmallest, kLargest)};
        const dBodyID box = addBox(position, sides, kDensity * sides.x * sides.y * sides.z);
        turnAtRandom(box, random);
    }
};

}  // namespace

std::unique_ptr<Scene> makePile(const SceneOptions &options) { return std::make_unique<Pile>(options); }

}  // namespace scenes
