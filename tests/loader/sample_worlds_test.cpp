// Sample worlds of the thesis's table B.1 against their facts: what there is in each, and how its robot
// moves.
#include "touched_models.h"

#include "loader/load_world.h"

#include <algorithm>
#include <cmath>

namespace {

using namespace small_world;

class SampleWorld : public testing::Test {
protected:
    explicit SampleWorld(const std::string &name) : scene(worlds::loadWorld(worlds::findWorld(name))) {}

    void expectObjects(std::size_t bodies, std::size_t joints, std::size_t staticShapes,
                       double stepSize) const {
        EXPECT_EQ(scene->inventory().bodies.size(), bodies);
        EXPECT_EQ(scene->inventory().joints.size(), joints);
        EXPECT_EQ(staticGeoms(*scene), staticShapes);
        EXPECT_DOUBLE_EQ(scene->stepSize(), stepSize);
    }
    double angle(const std::string &name) const { return dJointGetHingeAngle(joint(*scene, name)); }

    std::unique_ptr<worlds::SdfScene> scene;
};

double yaw(dBodyID body) { return std::atan2(dBodyGetRotation(body)[4], dBodyGetRotation(body)[0]); }
double upright(dBodyID body) { return dBodyGetRotation(body)[10]; }
double distance(const Vector3 &a, const Vector3 &b) { return std::hypot(a.x - b.x, a.y - b.y); }

class EpuckLine : public SampleWorld {
protected:
    EpuckLine() : SampleWorld("epuck_line") {}
};

TEST_F(EpuckLine, DrivesARoundBetweenBoxesAndWalls) {
    expectObjects(3, 2, 8, 0.032);
    const dBodyID robot = body(*scene, "robot::body");
    TouchedModels watch(*scene);
    scene->observe(&watch);
    runFor(*scene, 12);
    double turned = 0, last = yaw(robot);
    for (int i = 0; i < 2700; ++i) {  // 86 s
        scene->frame();
        turned += std::remainder(yaw(robot) - last, 2 * M_PI);
        last = yaw(robot);
        ASSERT_NEAR(distance(position(robot), {0, 0, 0}), 0.33, 0.03) << scene->time();
    }
    EXPECT_NEAR(turned, -2 * M_PI, 0.5);
    EXPECT_NEAR(velocity(robot).length(), 0.025, 0.001);
    EXPECT_EQ(watch.pairs.size(), 1u);  // the robot and the arena's floor
}

class Gantry : public SampleWorld {
protected:
    Gantry() : SampleWorld("gantry") {}
};

// The whole tower takes 129 s.
TEST_F(Gantry, TakesTheFirstBoxesToTheirPlaces) {
    expectObjects(13, 9, 7, 0.004);
    EXPECT_NEAR(totalMass(*scene, "crane"), 106 + 4 * 0.8042 + 1 + 3.217 + 11.054 + 2 * 0.64, 0.01);
    const Vector3 start{0, -0.8, 0}, middle{-0.4, 0, 0}, goal{-0.8, 0.8, 0};
    const auto box = [&](const char *name) { return position(body(*scene, name)); };
    runFor(*scene, 16 * 2.3);
    EXPECT_LT(distance(box("box_a::box"), goal), 0.03);
    EXPECT_NEAR(box("box_a::box").z, 0.14, 0.01);  // on the other platform
    EXPECT_LT(distance(box("box_b::box"), middle), 0.03);
    EXPECT_NEAR(box("box_b::box").z, 0.1, 0.01);  // on the floor
    EXPECT_LT(distance(box("box_c::box"), start), 0.03);
}

class Youbot : public SampleWorld {
protected:
    Youbot() : SampleWorld("youbot") {}
};

TEST_F(Youbot, CarriesTheBoxAwayAndPutsItOnTheFloor) {
    expectObjects(13, 11, 2, 0.016);
    const dBodyID base = body(*scene, "robot::base"), box = body(*scene, "kuka_box::box");
    runFor(*scene, 8);
    EXPECT_NEAR(angle("robot::arm_3_joint"), -0.77, 0.01);
    EXPECT_NEAR(position(box).z, 0.4125, 0.001);  // on the larger box
    runFor(*scene, 5);
    EXPECT_NEAR(position(box).z, 0.163, 0.005);  // on the robot
    runFor(*scene, 5);
    EXPECT_NEAR(position(base).y, 1, 0.01);  // strafed by its rollers
    EXPECT_NEAR(position(base).x, 0, 0.01);
    EXPECT_NEAR(position(box).y, 1, 0.01);
    runFor(*scene, 21);
    EXPECT_NEAR(yaw(base), -0.48, 0.05);
    EXPECT_NEAR(position(box).z, 0.0125, 0.001);
    EXPECT_NEAR(distance(position(box), position(base)), 0.29, 0.05);
}

class Surveyor : public SampleWorld {
protected:
    Surveyor() : SampleWorld("surveyor") {}
};

TEST_F(Surveyor, WandersAmongTheBoxes) {
    expectObjects(11, 10, 10, 0.016);
    EXPECT_NEAR(totalMass(*scene, "robot"), 0.374, 1e-12);
    const dBodyID robot = body(*scene, "robot::body");
    TouchedModels watch(*scene);
    scene->observe(&watch);
    runFor(*scene, 1);
    EXPECT_NEAR(velocity(robot).x, 0.3, 0.005);
    double turned = 0, last = yaw(robot), driven = 0;
    Vector3 lastPlace = position(robot);
    for (int i = 0; i < 3000; ++i) {  // 48 s
        scene->frame();
        turned += std::remainder(yaw(robot) - last, 2 * M_PI);
        driven += distance(position(robot), lastPlace);
        last = yaw(robot);
        lastPlace = position(robot);
    }
    EXPECT_GT(turned, 20);  // to the left
    EXPECT_GT(driven, 9);
    EXPECT_EQ(watch.pairs.size(), 1u);  // the robot and the arena's floor
    EXPECT_NEAR(position(robot).z, 0.028, 1e-3);
}

class Shrimp : public SampleWorld {
protected:
    Shrimp() : SampleWorld("shrimp") {}
};

TEST_F(Shrimp, ClimbsOverTheBallsAndTurnsOnTheSpot) {
    expectObjects(22, 27, 24, 0.016);
    const dBodyID robot = body(*scene, "robot::body");
    const dJointID spring = joint(*scene, "robot::spring");
    double highest = 0, shortest = 0, fork = 0;
    for (int i = 0; i < 1078; ++i) {  // 17.25 s
        scene->frame();
        highest = std::max(highest, position(robot).z);
        shortest = std::min(shortest, dJointGetSliderPosition(spring));
        fork = std::max(fork, angle("robot::upper_fork_pivot"));
        ASSERT_GT(upright(robot), 0.7) << scene->time();
    }
    EXPECT_GT(highest, 0.137 + 0.03);  // the balls are up to 0.1 m high
    EXPECT_LT(shortest, -0.005);
    EXPECT_GT(fork, 0.5);
    EXPECT_NEAR(position(robot).x, -0.25, 0.3);  // driven by 4.3 m
    const Vector3 place = position(robot);
    const double heading = yaw(robot);
    runFor(*scene, 1);
    EXPECT_NEAR(angle("robot::front_steering"), 1.336, 0.01);
    EXPECT_GT(std::remainder(yaw(robot) - heading, 2 * M_PI), 0.8);
    EXPECT_LT(distance(position(robot), place), 0.3);
    runFor(*scene, 5);
    EXPECT_LT(velocity(robot).length(), 0.01);
}

class Sojourner : public SampleWorld {
protected:
    Sojourner() : SampleWorld("sojourner") {}
};

TEST_F(Sojourner, ClimbsOverRocks) {
    expectObjects(15, 14, 7, 0.016);
    EXPECT_NEAR(totalMass(*scene, "robot"), 10.5, 1e-9);
    const dBodyID hull = body(*scene, "robot::hull");
    const Vector3 start = position(hull);
    double least = 0, most = 0;
    for (int i = 0; i < 3750; ++i) {  // 60 s
        scene->frame();
        least = std::min(least, angle("robot::left_bogie_pivot"));
        most = std::max(most, angle("robot::left_bogie_pivot"));
        ASSERT_GT(upright(hull), 0.9) << scene->time();
    }
    EXPECT_NEAR(start.y - position(hull).y, 0.039 * 60, 0.15);  // 0.6 rad/s on wheels of 65 mm
    EXPECT_GT(most, 0.3);
    EXPECT_LT(least, -0.1);
}

class AutonomousVehicle : public SampleWorld {
protected:
    AutonomousVehicle() : SampleWorld("autonomous_vehicle") {}
};

TEST_F(AutonomousVehicle, DrivesOnTheRingRoad) {
    expectObjects(5, 4, 17, 0.01);
    EXPECT_NEAR(totalMass(*scene, "car"), 2120, 1e-9);
    const dBodyID car = body(*scene, "car::body");
    TouchedModels watch(*scene);
    scene->observe(&watch);
    runFor(*scene, 10);
    EXPECT_NEAR(velocity(car).length() * 3.6, 50, 1);
    for (int i = 0; i < 4000; ++i) {  // a round takes 26 s
        scene->frame();
        ASSERT_NEAR(distance(position(car), {50.6, 57.2, 0}), 57.1, 0.5) << scene->time();
    }
    EXPECT_EQ(watch.pairs.size(), 1u);  // the car and the road
    EXPECT_GT(upright(car), 0.999);
}

class UnevenTerrain : public SampleWorld {
protected:
    UnevenTerrain() : SampleWorld("uneven_terrain") {}
};

// The formula of worlds/models/uneven_terrain/make_heights.py.
double height(double x, double y) {
    const double edge = (1 - std::pow(x / 25, 8)) * (1 - std::pow(y / 25, 8));
    return edge *
           (5.5 + 2 * std::sin(x / 4 + 1) * std::cos(y / 5) + 0.7 * std::sin(x / 1.9) * std::sin(y / 2.3));
}

TEST_F(UnevenTerrain, DrivesOverTheHills) {
    expectObjects(19, 12, 2, 0.004);
    const dBodyID chassis = body(*scene, "robot::chassis");
    double lowest = 100, highest = 0, driven = 0, leastAngle = 10, mostAngle = -10;
    Vector3 last = position(chassis);
    for (int i = 0; i < 7000; ++i) {  // 28 s
        scene->frame();
        const Vector3 place = position(chassis);
        driven += distance(place, last);
        last = place;
        if (i < 500) continue;
        ASSERT_NEAR(place.z, height(place.x, place.y) + 0.1, 0.1) << scene->time();
        lowest = std::min(lowest, place.z);
        highest = std::max(highest, place.z);
        leastAngle = std::min(leastAngle, angle("robot::front_left_suspension"));
        mostAngle = std::max(mostAngle, angle("robot::front_left_suspension"));
    }
    EXPECT_GT(driven, 9);
    EXPECT_GT(highest - lowest, 0.5);
    EXPECT_GT(mostAngle - leastAngle, 0.05);
}

class IprFactory : public SampleWorld {
protected:
    IprFactory() : SampleWorld("ipr_factory") {}
};

TEST_F(IprFactory, ArmsTakeObjectsFromTheBeltToTheRacks) {
    expectObjects(23, 15, 3 + 2 * (10 + 5 + 5), 0.02);
    const auto object = [&](int number) {
        return position(body(*scene, "object_" + std::to_string(number) + "::object"));
    };
    runFor(*scene, 5);
    EXPECT_NEAR(object(4).y, 4 - 0.15 * 5, 0.01);  // with the belt
    runFor(*scene, 6);
    EXPECT_NEAR(object(1).x, 0.42, 0.03);  // the first one is put down
    runFor(*scene, 59);
    int inRacks = 0;
    for (int i = 1; i <= 8; ++i) {
        EXPECT_GT(object(i).x, 0.1) << i;  // none is left on the belt
        inRacks += object(i).x > 0.2 && object(i).z > 0.66;
    }
    EXPECT_GE(inRacks, 6);
}

class Blimp : public SampleWorld {
protected:
    Blimp() : SampleWorld("blimp") {}
};

TEST_F(Blimp, FliesCirclesAboveTheTables) {
    expectObjects(1, 0, 11 + 17 * 6 + 4 * 4, 0.032);
    const dBodyID hull = body(*scene, "blimp::hull");
    runFor(*scene, 20);
    double turned = 0, last = yaw(hull);
    Vector3 least = position(hull), most = least;
    for (int i = 0; i < 1875; ++i) {  // 60 s
        scene->frame();
        turned += std::remainder(yaw(hull) - last, 2 * M_PI);
        last = yaw(hull);
        least = minOf(least, position(hull));
        most = maxOf(most, position(hull));
    }
    EXPECT_NEAR(turned / 60, 0.367, 0.02);  // rad/s: 0.0029 N·m against a drag of 0.0079 N·m·s
    EXPECT_NEAR(velocity(hull).length(), 0.18, 0.02);
    EXPECT_NEAR(most.x - least.x, 1, 0.2);
    EXPECT_GT(least.z, 1.7);
    EXPECT_LT(most.z, 2.3);
    EXPECT_GT(upright(hull), 0.999);
}

}  // namespace
