// A hanging net of N by N balls, each on ball joints to its neighbours; the balls of the top row are fixed. Balls do not collide.
//
// Facts: the scene joint_grid (N = 100: 19,701 joints) of Box3D's benchmark, 30c67b5: sizes, density, gravity, step.
#include "scenes/catalogue.h"
#include "scenes/world_scene.h"

#include <vector>

namespace scenes {

namespace {

constexpr dReal kPitch = 1;                        // m, from ball to ball
constexpr dReal kRadius = REAL(0.4);               // m
constexpr dReal kMass = REAL(268.08257310632899);  // kg, at 1000 kg/m³

class JointGrid final : public WorldScene {
public:
    explicit JointGrid(const SceneOptions &options) : WorldScene(options, kBox3DStepSize) {
        useBox3DDefaults();
        const int n = options.size;
        const dReal top = kPitch * n;  // m, so that the lowest balls stay above 0
        std::vector<dBodyID> before;   // the column to the left, from the top; null: fixed
        for (int column = 0; column < n; ++column) {
            std::vector<dBodyID> balls;
            for (int row = 0; row < n; ++row) {
                const Vector3 at{kPitch * column, 0, top - kPitch * row};
                balls.push_back(row == 0 ? addFixedBall(at) : addFreeBall(at));
                if (row == 0) continue;
                addBall(balls[row], balls[row - 1], at + Vector3{0, 0, kPitch / 2});
                if (column > 0) addBall(balls[row], before[row], at - Vector3{kPitch / 2, 0, 0});
            }
            before = balls;
        }
    }

private:
    dBodyID addFreeBall(const Vector3 &at) {
        const dBodyID body = addSphere(at, kRadius, kMass);
        dGeomSetCollideBits(dBodyGetFirstGeom(body), ~kDynamicCategory);
        return body;
    }

    dBodyID addFixedBall(const Vector3 &at) {
        dGeomSetCollideBits(addStaticSphere(at, kRadius), 0);
        return nullptr;
    }
};

}  // namespace

std::unique_ptr<Scene> makeJointGrid(const SceneOptions &options) { return std::make_unique<JointGrid>(options); }

}  // namespace scenes
