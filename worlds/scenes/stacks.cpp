// N stacks of ten boxes, far apart: as many islands of equal cost.
#include "scenes/catalogue.h"
#include "scenes/generator.h"
#include "scenes/world_scene.h"

#include <cmath>

namespace scenes {

namespace {

constexpr int kHeight = 10;              // boxes
constexpr dReal kSide = REAL(0.5);       // m
constexpr dReal kMass = 25;              // kg, a crate of 200 kg/m³
constexpr dReal kSpacing = 8;            // m: a stack that falls over reaches 5 m
constexpr dReal kJitter = REAL(0.01);    // m, so that no stack is a copy of another
constexpr dReal kDrop = REAL(0.002);     // m between boxes at the start
constexpr dReal kStepSize = REAL(0.01);  // s

class Stacks final : public WorldScene {
public:
    explicit Stacks(const SceneOptions &options) : WorldScene(options, kStepSize) {
        addGround();
        Generator random(1);
        const int columns = static_cast<int>(std::ceil(std::sqrt(options.size)));
        for (int i = 0; i < options.size; ++i) {
            const Vector3 foot{kSpacing * (i % columns), kSpacing * (i / columns), 0};
            addStack(foot, random);
        }
    }

private:
    void addStack(const Vector3 &foot, Generator &random) {
        for (int level = 0; level < kHeight; ++level) {
            const Vector3 offset{random.between(-kJitter, kJitter), random.between(-kJitter, kJitter),
                                 kSide / 2 + kDrop + level * (kSide + kDrop)};
            addBox(foot + offset, {kSide, kSide, kSide}, kMass);
        }
    }
};

}  // namespace

std::unique_ptr<Scene> makeStacks(const SceneOptions &options) { return std::make_unique<Stacks>(options); }

}  // namespace scenes
