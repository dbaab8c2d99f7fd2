// A wall of N by N bricks in stretcher bond: one island as large as the scene. With dWorldStep its
// cost grows with the sixth power of N.
#include "scenes/catalogue.h"
#include "scenes/world_scene.h"

namespace scenes {

namespace {

constexpr Vector3 kBrick{REAL(0.24), REAL(0.115), REAL(0.071)};  // m, standard format
constexpr dReal kMass = REAL(3.3);                               // kg
constexpr dReal kJoint = REAL(0.001);                            // m, gap between bricks of a course
constexpr dReal kStepSize = REAL(0.01);                          // s

class Wall final : public WorldScene {
public:
    explicit Wall(const SceneOptions &options) : WorldScene(options, kStepSize) {
        addGround();
        for (int course = 0; course < options.size; ++course)
            for (int i = 0; i < options.size; ++i) {
                const dReal along = i + (course % 2 ? REAL(0.5) : REAL(0.0));
                addBox({along * (kBrick.x + kJoint), 0, (course + REAL(0.5)) * kBrick.z}, kBrick, kMass);
            }
    }
};

}  // namespace

std::unique_ptr<Scene> makeWall(const SceneOptions &options) { return std::make_unique<Wall>(options); }

}  // namespace scenes
