// N rays of range finders that flying robots carry over 5000 objects on the ground. In every frame
// each ray is moved and cast at the whole space; its first hit is a reading of the scene, so that a
// wrong hit changes the state. The step is small: few bodies, which seldom collide.
#include "scenes/catalogue.h"
#include "scenes/generator.h"
#include "scenes/world_scene.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace scenes {

namespace {

constexpr int kThings = 5000;  // that do not move
constexpr dReal kField = 70;   // m, side of the square on which they are
constexpr dReal kRange = 8;    // m, of a ray
constexpr int kRaysOfASensor = 100;
constexpr int kLayers = 5;                                  // of rays, from level to steeply down
constexpr dReal kLayerAngle = REAL(0.14);                   // rad between layers
constexpr dReal kSpin = 2;                                  // rad/s, of a sensor
constexpr dReal kRobotRadius = REAL(0.2), kRobotMass = 1;   // m, kg
constexpr dReal kMast = REAL(0.25);                         // m from the robot's middle: its own rays miss it
constexpr dReal kLowest = REAL(1.5), kHighest = REAL(1.9);  // m, robots; above all things
constexpr dReal kCircle = 2;                                // m, radius of a robot's flight
constexpr dReal kFlight = REAL(0.5);                        // rad/s along the circle
constexpr dReal kStiffness = 20, kDamping = 9;              // N/m, N·s/m: hold a robot on its course
constexpr dReal kStepSize = REAL(0.01);  // s

class Rays final : public WorldScene {
public:
    explicit Rays(const SceneOptions &options) : WorldScene(options, kStepSize) {
        addGround();
        for (int i = 0; i < kThings; ++i) addThing();
        const int robots = (options.size + kRaysOfASensor - 1) / kRaysOfASensor;
        const int columns = static_cast<int>(std::ceil(std::sqrt(robots)));
        const dReal cell = kField / static_cast<dReal>(columns);
        for (int i = 0; i < robots; ++i)
            addRobot(cell * (i % columns + REAL(0.5)), cell * (i / columns + REAL(0.5)));
        for (int i = 0; i < options.size; ++i) addRay();
        numberGeoms();
        m_inventory.readings.resize(m_rays.size() * kNumbersOfAReading);
    }

    ~Rays() override {
        for (dGeomID ray : m_rays) dGeomDestroy(ray);  // they are in no space
    }

    void control() override {
        const dReal angle = kFlight * static_cast<dReal>(m_time);
        for (const Robot &robot : m_robots)
            fly(robot, robot.home + Vector3{kCircle * std::cos(angle), kCircle * std::sin(angle), 0});
        for (std::size_t i = 0; i < m_rays.size(); ++i) aim(i);
    }

    void collide() override {
        WorldScene::collide();
        for (std::size_t i = 0; i < m_rays.size(); ++i) cast(i);
    }

private:
    static constexpr std::size_t kNumbersOfAReading = 8;  // distance, place, normal, which geom

    struct Robot {
        dBodyID body;
        Vector3 home;  // the middle of its circle
    };

    struct Cast {
        Observer *observer;
        dGeomID ray;
        dContactGeom nearest;  // so far; its depth is the distance
        dGeomID met;           // null: nothing
    };

    void addThing() {
        const auto kind = m_random.next() % 4;
        const dReal x = m_random.between(0, kField), y = m_random.between(0, kField);
        const dReal width = m_random.between(REAL(0.3), REAL(1.2)),
                    height = m_random.between(REAL(0.3), REAL(1.2));
        const dReal radius = width / 2, thin = width / 4, middle = height / 2;
        if (kind == 0)
            addStaticBox({x, y, middle}, {width, height, height}, m_random.between(0, kPi));
        else if (kind == 1)
            addStaticSphere({x, y, radius}, radius);
        else if (kind == 2)
            addStaticCapsule({x, y, middle / 2 + thin}, thin, middle);
        else
            addStaticCylinder({x, y, middle}, radius, height);
    }

    void addRobot(dReal x, dReal y) {
        const Vector3 home{x, y, m_random.between(kLowest, kHighest)};
        m_robots.push_back({addSphere(home + Vector3{kCircle, 0, 0}, kRobotRadius, kRobotMass), home});
        dBodySetGravityMode(m_robots.back().body, 0);
    }

    // A ray has no body, but moves: static things are there to be hit.
    void addRay() {
        const dGeomID ray = add(dCreateRay(nullptr, kRange));
        dGeomSetCategoryBits(ray, kDynamicCategory);
        dGeomSetCollideBits(ray, ~0UL);
        m_rays.push_back(ray);
    }

    static void fly(const Robot &robot, const Vector3 &target) {
        const dReal *at = dBodyGetPosition(robot.body), *speed = dBodyGetLinearVel(robot.body);
        dBodyAddForce(robot.body, kStiffness * (target.x - at[0]) - kDamping * speed[0],
                      kStiffness * (target.y - at[1]) - kDamping * speed[1],
                      kStiffness * (target.z - at[2]) - kDamping * speed[2]);
    }

    void aim(std::size_t i) {
        const std::size_t robot = i / kRaysOfASensor, inFan = i % kRaysOfASensor;
        // Each robot looks another way, or they would all see their neighbours in the same frames.
        const dReal heading = kSpin * static_cast<dReal>(m_time) + static_cast<dReal>(robot);
        const dReal turn = heading + 2 * kPi / kRaysOfASensor * static_cast<dReal>(inFan);
        const dReal down = kLayerAngle * static_cast<dReal>(inFan % kLayers);
        const dReal *at = dBodyGetPosition(m_robots[robot].body);
        dGeomRaySet(m_rays[i], at[0], at[1], at[2] + kMast, std::cos(down) * std::cos(turn),
                    std::cos(down) * std::sin(turn), -std::sin(down));
    }

    void cast(std::size_t i) {
        Cast cast{m_observer, m_rays[i], {}, nullptr};
        cast.nearest.depth = kRange;
        dSpaceCollide2(m_rays[i], reinterpret_cast<dGeomID>(space()), &cast, &Rays::meet);
        read(cast, &m_inventory.readings[kNumbersOfAReading * i]);
        if (m_observer) m_observer->note("distance that a ray measured", cast.nearest.depth);
    }

    // Of two hits at the same distance the first counts, so the result depends on the order of pairs, too.
    static void meet(void *data, dGeomID o1, dGeomID o2) {
        Cast &cast = *static_cast<Cast *>(data);
        if (cast.observer) cast.observer->nearPair(o1, o2);
        dContactGeom hit;
        if (!dCollide(o1, o2, 1, &hit, sizeof hit) || hit.depth >= cast.nearest.depth) return;
        cast.nearest = hit;
        cast.met = o1 == cast.ray ? o2 : o1;
    }

    static void read(const Cast &cast, dReal *numbers) {
        *numbers++ = cast.nearest.depth;
        numbers = std::copy_n(cast.nearest.pos, 3, numbers);
        numbers = std::copy_n(cast.nearest.normal, 3, numbers);
        *numbers =
            cast.met ? static_cast<dReal>(reinterpret_cast<std::uintptr_t>(dGeomGetData(cast.met))) : -1;
    }

    // In the inventory: what a reading names a geom by, as no address may.
    void numberGeoms() {
        for (std::size_t i = 0; i < m_inventory.geoms.size(); ++i)
            dGeomSetData(m_inventory.geoms[i], reinterpret_cast<void *>(i));
    }

    std::vector<Robot> m_robots;
    std::vector<dGeomID> m_rays;
    Generator m_random{7};
};

}  // namespace

std::unique_ptr<Scene> makeRays(const SceneOptions &options) { return std::make_unique<Rays>(options); }

}  // namespace scenes
