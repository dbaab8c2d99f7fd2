// A hanging chain of N capsules and ball joints that starts level and swings down: one island
// without contacts at first.
#include "scenes/catalogue.h"
#include "scenes/world_scene.h"

namespace scenes {

namespace {

constexpr dReal kRadius = REAL(0.04), kLength = REAL(0.2);  // m; a link is as long as its cylinder
constexpr dReal kMass = 1;                                  // kg
constexpr dReal kDamping = REAL(0.002);                     // of the velocity, a step
constexpr dReal kStepSize = REAL(0.005);                    // s

class Chain final : public WorldScene {
public:
    explicit Chain(const SceneOptions &options) : WorldScene(options, kStepSize) {
        dWorldSetDamping(world(), kDamping, kDamping);
        const dReal height = kLength * options.size + 1;  // m, so that it never reaches the ground
        dBodyID previous = nullptr;
        for (int i = 0; i < options.size; ++i) {
            const dBodyID link =
                addCapsule({kLength * (i + REAL(0.5)), 0, height}, kAxisX, kRadius, kLength, kMass);
            addBall(link, previous, {kLength * i, 0, height});
            previous = link;
        }
        addGround();
    }
};

}  // namespace

std::unique_ptr<Scene> makeChain(const SceneOptions &options) { return std::make_unique<Chain>(options); }

}  // namespace scenes
