// What every scene must be: deterministic, finite, free of static pairs, and what its name says.
#include "scenes/scene.h"
#include "scenes/state_hash.h"
#include "scenes/terrain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace {

using scenes::makeScene;
using scenes::Scene;

class Ode : public testing::Environment {
public:
    void SetUp() override { dInitODE2(0); }
    void TearDown() override { dCloseODE(); }
};
const auto *const kOde = testing::AddGlobalTestEnvironment(new Ode);

void run(Scene &scene, int frames) {
    for (int i = 0; i < frames; ++i) scene.frame();
}

// QuickStep draws from ODE's own generator, whose sequence continues from scene to scene.
std::uint64_t hashAfter(const std::string &description, int frames) {
    dRandSetSeed(0);
    const auto scene = makeScene(description);
    run(*scene, frames);
    return scenes::stateHash(scene->inventory());
}

bool isFinite(const Scene &scene) {
    for (dBodyID body : scene.inventory().bodies)
        for (int i = 0; i < 3; ++i)
            if (!std::isfinite(dBodyGetPosition(body)[i]) || !std::isfinite(dBodyGetLinearVel(body)[i]))
                return false;
    return true;
}

dReal height(const Scene &scene, std::size_t body) {
    return dBodyGetPosition(scene.inventory().bodies[body])[2];
}

class Pairs final : public scenes::Observer {
public:
    void nearPair(dGeomID o1, dGeomID o2) override {
        ++count;
        if (isStatic(o1) && isStatic(o2)) ++staticPairs;
    }
    void contact(const dContact &contact) override {
        ++contacts;
        if (!isStatic(contact.geom.g1) && !isStatic(contact.geom.g2)) ++contactsOfBodies;
        if (std::fabs(dCalcVectorLength3(contact.geom.normal) - 1) > REAL(1e-3)) ++brokenNormals;
    }

    std::size_t count = 0, staticPairs = 0, contacts = 0, contactsOfBodies = 0, brokenNormals = 0;

private:
    static bool isStatic(dGeomID geom) { return !dGeomGetBody(geom) && dGeomGetClass(geom) != dRayClass; }
};

std::size_t countOfClass(const Scene &scene, int geomClass) {
    const auto &geoms = scene.inventory().geoms;
    return static_cast<std::size_t>(std::count_if(
        geoms.begin(), geoms.end(), [=](dGeomID geom) { return dGeomGetClass(geom) == geomClass; }));
}

std::vector<std::string> allNames() {
    std::vector<std::string> names;
    for (const scenes::SceneDescription &scene : scenes::availableScenes()) names.push_back(scene.name);
    return names;
}

class EveryScene : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Scenes, EveryScene, testing::ValuesIn(allNames()),
                         [](const auto &info) { return info.param; });

}  // namespace

TEST_P(EveryScene, RunsTheSameTwice) {
    const std::string description = GetParam() + ":4";
    EXPECT_EQ(hashAfter(description, 60), hashAfter(description, 60));
    EXPECT_NE(hashAfter(description, 60), hashAfter(description, 61));
}

TEST_P(EveryScene, StaysFiniteAndAboveTheGround) {
    const auto scene = makeScene(GetParam() + ":4");
    run(*scene, 300);
    EXPECT_TRUE(isFinite(*scene));
    for (std::size_t i = 0; i < scene->inventory().bodies.size(); ++i) EXPECT_GT(height(*scene, i), -1) << i;
    EXPECT_NEAR(scene->time(), 300 * scene->stepSize(), 1e-3);
}

TEST_P(EveryScene, NeverTestsStaticAgainstStatic) {
    for (const char *space : {"simple", "hash", "sap", "quadtree"}) {
        const auto scene = makeScene(GetParam() + ":4," + space);
        Pairs pairs;
        scene->observe(&pairs);
        run(*scene, 50);
        EXPECT_EQ(pairs.staticPairs, 0u) << space;
        // Balls of the net do not collide, and cubes fall for longer until they meet the drum.
        if (GetParam() != "joint_grid" && GetParam() != "washer") { EXPECT_GT(pairs.count, 0u) << space; }
    }
}

TEST_P(EveryScene, RunsWithBothSteppersAndAutoDisable) {
    for (const char *modifiers : {"world", "quick", "world,autodisable", "quick,autodisable"}) {
        const auto scene = makeScene(GetParam() + ":2," + modifiers);
        run(*scene, 50);
        EXPECT_TRUE(isFinite(*scene)) << modifiers;
    }
}

TEST_P(EveryScene, GrowsWithItsSize) {
    const auto small = makeScene(GetParam() + ":2"), large = makeScene(GetParam() + ":5");
    EXPECT_GT(large->inventory().geoms.size(), small->inventory().geoms.size());
}

TEST(Scenes, ObserverSeesEveryContact) {
    const auto scene = makeScene("stacks:1");
    Pairs pairs;
    scene->observe(&pairs);
    std::size_t contacts = 0;
    for (int i = 0; i < 20; ++i) {
        scene->frame();
        contacts += scene->contactCount();
    }
    EXPECT_EQ(pairs.contacts, contacts);
    EXPECT_GT(contacts, 0u);
}

TEST(Scenes, AHumanoidHasSeventeenBodiesAndSixteenMotors) {
    const auto scene = makeScene("humanoids:1");
    EXPECT_EQ(scene->inventory().bodies.size(), 17u);
    EXPECT_EQ(scene->inventory().joints.size(), 16u);
    int motors = 0;
    for (dJointID joint : scene->inventory().joints) {
        const bool isHinge = dJointGetType(joint) == dJointTypeHinge;
        const dReal torque =
            isHinge ? dJointGetHingeParam(joint, dParamFMax) : dJointGetUniversalParam(joint, dParamFMax);
        if (torque > 0) ++motors;
    }
    EXPECT_EQ(motors, 16);
}

TEST(Scenes, HumanoidsBendTheirKneesAndStayUpright) {
    const auto scene = makeScene("humanoids:1");
    const std::size_t head = 2;
    const dReal standing = height(*scene, head);
    dReal lowest = standing;
    for (int i = 0; i < 1000; ++i) {
        scene->frame();
        lowest = std::min(lowest, height(*scene, head));
    }
    EXPECT_LT(lowest, standing - REAL(0.01));
    EXPECT_GT(lowest, standing - REAL(0.1));
}

// The numbers that Box3D's benchmark has.
TEST(Scenes, Box3DsScenesHaveItsBodiesAndJoints) {
    EXPECT_EQ(makeScene("pyramid")->inventory().bodies.size(), 5050u);
    EXPECT_EQ(makeScene("pyramids")->inventory().bodies.size(), 10780u);
    const auto grid = makeScene("joint_grid");
    EXPECT_EQ(grid->inventory().joints.size(), 19701u);
    EXPECT_EQ(grid->inventory().bodies.size(), 9900u);
    EXPECT_EQ(makeScene("convex_pile")->inventory().bodies.size(), 5120u);
    EXPECT_EQ(makeScene("junkyard")->inventory().bodies.size(), 10584u + 1);
    EXPECT_EQ(makeScene("washer")->inventory().bodies.size(), 8000u + 1);
}

TEST(Scenes, APyramidStaysUp) {
    const auto scene = makeScene("pyramid:8");
    run(*scene, 300);
    EXPECT_GT(height(*scene, scene->inventory().bodies.size() - 1), REAL(7.4));
}

// The ribs lift cubes far above the lowest place of the drum, and most cubes stay inside.
TEST(Scenes, AWasherLiftsCubes) {
    const auto scene = makeScene("washer:4");
    const std::size_t cubes = scene->inventory().bodies.size() - 1;
    dReal highest = 0;
    for (int i = 0; i < 900; ++i) {
        scene->frame();
        if (i > 300)
            for (std::size_t cube = 1; cube <= cubes; ++cube) highest = std::max(highest, height(*scene, cube));
    }
    std::size_t inside = 0;
    for (std::size_t cube = 1; cube <= cubes; ++cube) inside += height(*scene, cube) > 3;
    EXPECT_GT(highest, 20);
    EXPECT_GT(inside, cubes / 2);
}

TEST(Scenes, StacksStayUp) {
    const auto scene = makeScene("stacks:3");
    const std::size_t top = 9;
    run(*scene, 500);
    EXPECT_GT(height(*scene, top), REAL(4.6));
}

// A settled crowd rests; in a churn what came in the last frames still falls.
TEST(Scenes, ChurnExchangesOneBoxAFrameAndACrowdNone) {
    const auto falling = [](const Scene &scene) {
        int count = 0;
        for (const dBodyID body : scene.inventory().bodies) count += dBodyGetLinearVel(body)[2] < REAL(-0.05);
        return count;
    };
    const auto crowd = makeScene("crowd:40"), churn = makeScene("churn:40");
    run(*crowd, 200);
    run(*churn, 200);
    EXPECT_EQ(falling(*crowd), 0);
    EXPECT_GT(falling(*churn), 0);
    for (const Scene *scene : {crowd.get(), churn.get()}) {
        const scenes::Inventory &all = scene->inventory();
        ASSERT_EQ(all.bodies.size(), 40u);
        ASSERT_EQ(all.geoms.size(), 41u);
        for (std::size_t i = 0; i < all.bodies.size(); ++i)
            EXPECT_EQ(dGeomGetBody(all.geoms[i + 1]), all.bodies[i]);
    }
}

TEST(Scenes, PilesCollapse) {
    const auto scene = makeScene("pile:100");
    const std::size_t last = 99;
    const dReal before = height(*scene, last);
    run(*scene, 300);
    EXPECT_LT(height(*scene, last), before / 2);
}

TEST(Scenes, BallsStayInTheirBox) {
    const auto scene = makeScene("spheres:60");
    run(*scene, 400);
    for (dBodyID ball : scene->inventory().bodies)
        for (int axis : {0, 1}) {
            EXPECT_GT(dBodyGetPosition(ball)[axis], 0);
            EXPECT_LT(dBodyGetPosition(ball)[axis], REAL(0.22) * 4);
        }
}

TEST(Scenes, TheRoverDrivesAndStaysInsideItsWalls) {
    const auto scene = makeScene("rover:8");
    dReal farthest = 0;
    for (int i = 0; i < 1500; ++i) {
        scene->frame();
        const dReal *position = dBodyGetPosition(scene->inventory().bodies[0]);
        farthest = std::max({farthest, std::fabs(position[0]), std::fabs(position[1])});
    }
    EXPECT_GT(farthest, 1);
    EXPECT_LT(farthest, REAL(4.5));
}

TEST(Scenes, BuggiesDriveInCircles) {
    for (const char *name : {"vehicles:1", "vehicles_heightfield:1"}) {
        const auto scene = makeScene(name);
        const dReal *position = dBodyGetPosition(scene->inventory().bodies[0]);
        const dReal startX = position[0], startY = position[1];
        dReal farthest = 0;
        for (int i = 0; i < 2000; ++i) {
            scene->frame();
            farthest = std::max(farthest, std::hypot(position[0] - startX, position[1] - startY));
        }
        EXPECT_GT(farthest, 3) << name;
        EXPECT_LT(farthest, 20) << name;
        const dReal *up = dBodyGetRotation(scene->inventory().bodies[0]) + 8;
        EXPECT_GT(up[2], REAL(0.7)) << name << " lies on its side";
    }
}

TEST(Scenes, ThingsLieOnTheTerrainAndOnOneAnother) {
    for (const auto &[name, ground] : {std::pair("mesh_terrain:120", dTriMeshClass),
                                       std::pair("heightfield_terrain:120", dHeightfieldClass)}) {
        const auto scene = makeScene(name);
        EXPECT_EQ(countOfClass(*scene, ground), 1u) << name;
        for (int kind : {dBoxClass, dSphereClass, dCapsuleClass, dCylinderClass})
            EXPECT_GT(countOfClass(*scene, kind), 15u) << name;
        run(*scene, 300);
        Pairs pairs;
        scene->observe(&pairs);
        scene->frame();
        EXPECT_GT(pairs.contactsOfBodies, 10u) << name;
        EXPECT_GT(pairs.contacts - pairs.contactsOfBodies, 120u) << name;
        EXPECT_EQ(pairs.brokenNormals, 0u) << name;
        for (dBodyID body : scene->inventory().bodies) {
            const dReal *at = dBodyGetPosition(body);
            const dReal ground = scenes::Terrain::height(at[0], at[1]);
            EXPECT_GT(at[2], ground - REAL(0.4)) << name;
            EXPECT_LT(at[2], ground + REAL(1.5)) << name;
            EXPECT_GT(std::min(at[0], at[1]), 0) << name;
        }
    }
}

TEST(Scenes, ConvexSolidsAreHalfPolyhedraAndMeetWithSoundNormals) {
    const auto scene = makeScene("convex:200");
    EXPECT_EQ(countOfClass(*scene, dConvexClass), 100u);
    EXPECT_EQ(countOfClass(*scene, dCylinderClass), 100u);
    Pairs pairs;
    scene->observe(&pairs);
    run(*scene, 300);
    EXPECT_GT(pairs.contactsOfBodies, 1000u);
    EXPECT_EQ(pairs.brokenNormals, 0u);
}

namespace {

// What a ray of the scene "rays" reports: eight numbers.
struct Reading {
    Reading(const Scene &scene, std::size_t ray) : numbers(&scene.inventory().readings[8 * ray]) {}
    dReal distance() const { return numbers[0]; }
    const dReal *place() const { return numbers + 1; }
    const dReal *normal() const { return numbers + 4; }
    long geom() const { return std::lround(numbers[7]); }

    const dReal *numbers;
};

std::vector<dGeomID> raysOf(const Scene &scene) {
    std::vector<dGeomID> rays = scene.inventory().geoms;
    rays.erase(
        std::remove_if(rays.begin(), rays.end(), [](dGeomID g) { return dGeomGetClass(g) != dRayClass; }),
        rays.end());
    return rays;
}

// Without any space.
dContactGeom nearestHit(const Scene &scene, dGeomID ray) {
    dContactGeom nearest{}, hit;
    nearest.depth = dGeomRayGetLength(ray);
    for (dGeomID geom : scene.inventory().geoms)
        if (geom != ray && dCollide(ray, geom, 1, &hit, sizeof hit) && hit.depth < nearest.depth)
            nearest = hit;
    return nearest;
}

}  // namespace

TEST(Scenes, EveryRayReportsTheNearestThingItMeets) {
    const auto scene = makeScene("rays:150");
    run(*scene, 40);
    scene->control();
    scene->collide();
    const std::vector<dGeomID> rays = raysOf(*scene);
    ASSERT_EQ(rays.size(), 150u);
    ASSERT_EQ(scene->inventory().readings.size(), 8 * 150u);
    int hits = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Reading reading(*scene, i);
        const dContactGeom nearest = nearestHit(*scene, rays[i]);
        EXPECT_EQ(reading.distance(), nearest.depth) << i;
        EXPECT_EQ(reading.geom() < 0, nearest.g1 == nullptr) << i;
        if (reading.geom() < 0) continue;
        ++hits;
        EXPECT_EQ(scene->inventory().geoms[static_cast<std::size_t>(reading.geom())], nearest.g2) << i;
        EXPECT_NEAR(dCalcVectorLength3(reading.normal()), 1, 1e-5);
        EXPECT_NEAR(dCalcPointsDistance3(reading.place(), dGeomGetPosition(rays[i])), reading.distance(),
                    1e-4);
    }
    EXPECT_GT(hits, 50);
    EXPECT_LT(hits, 150);
}

TEST(Scenes, RaysMeetRobotsThatMove) {
    const auto scene = makeScene("rays:10000");
    scene->frame();
    int met = 0;
    for (std::size_t i = 0; i < 10000; ++i) {
        const long geom = Reading(*scene, i).geom();
        if (geom >= 0 && dGeomGetBody(scene->inventory().geoms[static_cast<std::size_t>(geom)])) ++met;
    }
    EXPECT_GT(met, 0);
}
