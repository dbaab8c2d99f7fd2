// A wall of N by N bricks in stretcher bond: one island as large as the scene. With dWorldStep its
// cost grows with the sixth power of N. Or sixteen such walls, each an island: large problems side by side.
#include "scenes/catalogue.h"
#include "scenes/world_scene.h"

namespace scenes {

namespace {

constexpr Vector3 kBrick{REAL(0.24), REAL(0.115), REAL(0.071)};  // m, standard format
constexpr dReal kMass = REAL(3.3);                               // kg
constexpr dReal kJoint = REAL(0.001);                            // m, gap between bricks of a course
constexpr dReal kDistance = 5;                                   // m, from wall to wall
constexpr int kWalls = 16;
constexpr dReal kStepSize = REAL(0.01);                          // s

class Wall final : public WorldScene {
public:
    Wall(const SceneOptions &options, int walls) : WorldScene(options, kStepSize) {
        addGround();
        for (int wall = 0; wall < walls; ++wall) addWall(options, wall * kDistance);
    }

private:
    void addWall(const SceneOptions &options, dReal y) {
        for (int course = 0; course < options.size; ++course)
            for (int i = 0; i < options.size; ++i) {
                const dReal along = i + (course % 2 ? REAL(0.5) : REAL(0.0));
                addBox({along * (kBrick.x + kJoint), y, (course + REAL(0.5)) * kBrick.z}, kBrick, kMass);
            }
    }
};

}  // namespace

std::unique_ptr<Scene> makeWall(const SceneOptions &options) { return std::make_unique<Wall>(options, 1); }

std::unique_ptr<Scene> makeWalls(const SceneOptions &options) { return std::make_unique<Wall>(options, kWalls); }

}  // namespace scenes
