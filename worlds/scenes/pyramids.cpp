// Flat pyramids of cubes, each cube on two others: one with N cubes at its base, or 196 of them, each an island.
//
// Facts: the scenes large_pyramid (N = 100) and many_pyramids (N = 10) of Box3D's benchmark, 30c67b5: sizes, density, friction, gravity, step.
#include "scenes/catalogue.h"
#include "scenes/world_scene.h"

namespace scenes {

namespace {

constexpr dReal kSide = 1;                // m
constexpr dReal kMass = 100;              // kg, at 100 kg/m³
constexpr int kRows = 14, kColumns = 14;  // of the many pyramids

class Pyramids final : public WorldScene {
public:
    Pyramids(const SceneOptions &options, int rows, int columns) : WorldScene(options, kBox3DStepSize) {
        useBox3DDefaults();
        addGround();
        const int base = options.size;
        // Pyramids of a row stand a cube apart. Rows fill the square that the columns span.
        const dReal width = (base + 1) * kSide;
        for (int row = 0; row < rows; ++row)
            for (int column = 0; column < columns; ++column) addPyramid({column * width, row * width, 0}, base);
    }

private:
    void addPyramid(const Vector3 &corner, int base) {
        for (int layer = 0; layer < base; ++layer)
            for (int i = layer; i < base; ++i) {
                const Vector3 offset{(i - layer * REAL(0.5)) * kSide, 0, (layer + REAL(0.5)) * kSide};
                addBox(corner + offset, {kSide, kSide, kSide}, kMass);
            }
    }
};

}  // namespace

std::unique_ptr<Scene> makePyramid(const SceneOptions &options) { return std::make_unique<Pyramids>(options, 1, 1); }

std::unique_ptr<Scene> makePyramids(const SceneOptions &options) { return std::make_unique<Pyramids>(options, kRows, kColumns); }

}  // namespace scenes
