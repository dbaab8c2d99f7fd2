// N boxes, each lying on the ground by itself; in "churn" one of them goes and one comes in every frame, so
// that the two scenes differ by what a change of the world costs.
#include "scenes/catalogue.h"
#include "scenes/generator.h"
#include "scenes/world_scene.h"

#include <cmath>
#include <cstddef>

namespace scenes {

namespace {

constexpr dReal kShortest = REAL(0.3), kLongest = REAL(0.6);  // m, edge
constexpr dReal kDensity = 200;                               // kg/m³, a crate
constexpr dReal kSpacing = REAL(1.2);                         // m: boxes do not touch
constexpr dReal kDrop = REAL(0.003);                           // m above the ground: two frames of falling
constexpr dReal kStepSize = REAL(0.01);                       // s

class Crowd : public WorldScene {
public:
    explicit Crowd(const SceneOptions &options)
        : WorldScene(options, kStepSize), m_columns(static_cast<int>(std::ceil(std::sqrt(options.size)))) {
        addGround();
        for (int place = 0; place < options.size; ++place) addAt(place);
    }

protected:
    void addAt(int place) {
        const auto edge = [&] { return m_random.between(kShortest, kLongest); };
        const Vector3 sides{edge(), edge(), edge()};
        const dReal row = dReal(place / m_columns), column = dReal(place % m_columns);
        addBox({kSpacing * column, kSpacing * row, sides.z / 2 + kDrop}, sides,
               kDensity * sides.x * sides.y * sides.z);
    }

private:
    const int m_columns;
    Generator m_random{4};
};

class Churn final : public Crowd {
public:
    explicit Churn(const SceneOptions &options) : Crowd(options), m_size(options.size) {}

    void control() override {
        remove(m_next);
        addAt(m_next);
        takeItsPlace(m_inventory.bodies, bodyAt(m_next));
        takeItsPlace(m_inventory.geoms, geomAt(m_next));
        m_next = (m_next + 1) % m_size;
    }

private:
    static std::size_t bodyAt(int place) { return static_cast<std::size_t>(place); }
    static std::size_t geomAt(int place) { return bodyAt(place) + 1; }  // behind the ground

    void remove(int place) {
        dGeomDestroy(m_inventory.geoms[geomAt(place)]);
        dBodyDestroy(m_inventory.bodies[bodyAt(place)]);
    }

    // The box added last is at the position of the one removed.
    template <class Objects>
    static void takeItsPlace(Objects &objects, std::size_t gone) {
        objects[gone] = objects.back();
        objects.pop_back();
    }

    const int m_size;
    int m_next = 0;
};

}  // namespace

std::unique_ptr<Scene> makeCrowd(const SceneOptions &options) { return std::make_unique<Crowd>(options); }
std::unique_ptr<Scene> makeChurn(const SceneOptions &options) { return std::make_unique<Churn>(options); }

}  // namespace scenes
