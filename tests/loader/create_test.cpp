// The world create against its facts.
#include "box_sums.h"

#include "loader/load_world.h"

#include <cmath>

namespace {

using namespace small_world;

class Create : public testing::Test {
protected:
    std::unique_ptr<worlds::SdfScene> scene = worlds::loadWorld(worlds::findWorld("create"));

    // The robot's origin; its centre of mass is 16.8 mm in front and 1.4 mm below.
    Vector3 origin() const {
        dVector3 point;
        dBodyGetRelPointPos(body(*scene, "robot::base"), -0.0168, 0, 0.0014, point);
        return Vector3{point[0], point[1], point[2]};
    }
    double doorAngle() const { return dJointGetHingeAngle(joint(*scene, "door::hinge")); }
};

TEST_F(Create, HasTheObjectsOfTheFile) {
    EXPECT_EQ(staticGeoms(*scene), 44u);
    EXPECT_EQ(scene->inventory().bodies.size(), 5u);  // robot 3, door, virtual wall
    EXPECT_EQ(scene->inventory().joints.size(), 3u);
    EXPECT_EQ(scene->inventory().geoms.size(), 44u + 5u + 1u + 11u);
    EXPECT_NEAR(totalMass(*scene, "robot"), 2.4, 1e-12);
    EXPECT_NEAR(totalMass(*scene, "door"), 19.4625, 1e-12);
    EXPECT_NEAR(totalMass(*scene, "virtual_wall"), 0.2, 1e-12);
}

TEST_F(Create, PutsTheFurnitureWhereTheFileHasIt) {
    const BoxSums sums = sumOfStaticBoxes(*scene);
    EXPECT_EQ(sums.count, 40);
    EXPECT_LT((sums.center - Vector3{11.4259, -29.4137, 25.175}).length(), 1e-9);
    EXPECT_NEAR(sums.volume, 35.99939, 1e-5);
    const dReal *shade = dGeomGetPosition(geom(*scene, "floor_lamp::floor_lamp::shade"));
    EXPECT_DOUBLE_EQ(shade[2], 1.524);
    const dReal *back = dGeomGetRotation(geom(*scene, "armchair::armchair::back_cushion"));
    EXPECT_NEAR(back[10], std::cos(0.29), 1e-9);  // leans back by 0.29 rad
}

TEST_F(Create, DoorIsOneBodyOfLeafAndHandle) {
    const dBodyID leaf = body(*scene, "door::leaf");
    EXPECT_LT((position(leaf) - Vector3{-1.424, 0.0139, 1}).length(), 1e-9);
    const dMass mass = massOf(leaf);
    EXPECT_NEAR(mass.I[0], 7.611, 1e-9);
    EXPECT_NEAR(mass.I[5], 6.105, 1e-9);
    EXPECT_NEAR(mass.I[10], 1.518, 1e-9);
    EXPECT_DOUBLE_EQ(dJointGetHingeParam(joint(*scene, "door::hinge"), dParamLoStop), -1.57);
    EXPECT_DOUBLE_EQ(dJointGetHingeParam(joint(*scene, "door::hinge"), dParamHiStop), 0.01);
}

TEST_F(Create, RobotDropsAndRests) {
    EXPECT_NEAR(origin().z, 0.0899546, 1e-9);
    runFor(*scene, 0.512);  // the controller starts to drive after 0.5 s
    runFor(*scene, 2);
    EXPECT_NEAR(origin().z, 0.045, 0.002);  // contacts are soft
    EXPECT_NEAR(velocity(body(*scene, "robot::base")).x, 0.496, 0.005);
}

class FirstTouch : public scenes::Observer {
public:
    FirstTouch(const scenes::Scene &scene, dBodyID one, dBodyID other)
        : m_scene(scene), m_one(one), m_other(other) {}
    void contact(const dContact &contact) override {
        const dBodyID a = dGeomGetBody(contact.geom.g1), b = dGeomGetBody(contact.geom.g2);
        if (time < 0 && ((a == m_one && b == m_other) || (a == m_other && b == m_one))) time = m_scene.time();
    }
    double time = -1;

private:
    const scenes::Scene &m_scene;
    dBodyID m_one, m_other;
};

TEST_F(Create, RobotMeetsTheDoorAfter4s) {
    FirstTouch touch(*scene, body(*scene, "robot::base"), body(*scene, "door::leaf"));
    scene->observe(&touch);
    runFor(*scene, 6);
    EXPECT_NEAR(touch.time, 0.5 + 4.2, 0.15);
    EXPECT_LT(doorAngle(), -0.01);  // pushed open a little
    EXPECT_GT(doorAngle(), -0.2);
}

TEST_F(Create, DoorSlowsDownByItsDamping) {
    const dBodyID leaf = body(*scene, "door::leaf");
    runFor(*scene, 0.32);
    const double start = -0.5;  // rad/s
    dBodySetAngularVel(leaf, 0, 0, start);
    dBodySetLinearVel(leaf, -start * (0.0139 + 0.475), start * (-1.424 + 1.45), 0);
    dBodyEnable(leaf);
    runFor(*scene, 0.64);
    // Moment of inertia about the hinge, and 10 N·m·s/rad.
    const double inertia = 1.518 + 19.4625 * (0.4889 * 0.4889 + 0.026 * 0.026);
    EXPECT_NEAR(dJointGetHingeAngleRate(joint(*scene, "door::hinge")), start * std::exp(-10 / inertia * 0.64),
                0.02);
}

TEST_F(Create, RunsOn) {
    for (int i = 0; i < 2000; ++i) scene->frame();
    EXPECT_TRUE(isFinite(*scene));
    EXPECT_GT(origin().z, 0);
    EXPECT_LT(std::fabs(origin().x), 5);  // within the flat
    EXPECT_LT(std::fabs(origin().y), 5);
}

}  // namespace
