// <inertial auto="true">: the mass of a link is that of its shapes, as ODE computes it.
#include "small_world.h"

#include "loader/read/shape_mass.h"

#include <random>

namespace {

using namespace small_world;
using namespace worlds;

std::mt19937 draw(20);
double drawn(double least, double most) { return std::uniform_real_distribution<double>(least, most)(draw); }
Pose drawnPose() {
    return {{drawn(-2, 2), drawn(-2, 2), drawn(-2, 2)}, Quaternion::fromRollPitchYaw(drawn(-3, 3), drawn(-1, 1), drawn(-3, 3))};
}

Collision collisionOf(const Shape &shape, const Pose &pose = {}) { return {"", {}, shape, pose, {}, 0}; }

// ODE's, of a shape in that pose.
dMass placed(dMass mass, const Pose &pose) {
    const Quaternion q = pose.rotation;
    const dQuaternion quaternion = {dReal(q.w), dReal(q.x), dReal(q.y), dReal(q.z)};
    dMatrix3 rotation;
    dRfromQ(rotation, quaternion);
    dMassRotate(&mass, rotation);
    dMassTranslate(&mass, dReal(pose.position.x), dReal(pose.position.y), dReal(pose.position.z));
    return mass;
}
dMass odesMass(const Box &box, double density) {
    dMass mass;
    dMassSetBox(&mass, dReal(density), dReal(box.size.x), dReal(box.size.y), dReal(box.size.z));
    return mass;
}
dMass odesMass(const Sphere &sphere, double density) {
    dMass mass;
    dMassSetSphere(&mass, dReal(density), dReal(sphere.radius));
    return mass;
}
dMass odesMass(const Cylinder &cylinder, double density) {
    dMass mass;
    dMassSetCylinder(&mass, dReal(density), 3, dReal(cylinder.radius), dReal(cylinder.length));
    return mass;
}
dMass odesMass(const Capsule &capsule, double density) {
    dMass mass;
    dMassSetCapsule(&mass, dReal(density), 3, dReal(capsule.radius), dReal(capsule.length));
    return mass;
}

void expectSame(const Mass &mass, dMass expected) {
    constexpr double kShare = sizeof(dReal) == 8 ? 1e-9 : 1e-4;
    EXPECT_NEAR(mass.mass, expected.mass, kShare * expected.mass);
    EXPECT_NEAR(mass.center.x, expected.c[0], kShare);
    EXPECT_NEAR(mass.center.y, expected.c[1], kShare);
    EXPECT_NEAR(mass.center.z, expected.c[2], kShare);
    const double scale = expected.I[0] + expected.I[5] + expected.I[10];
    dMassTranslate(&expected, -expected.c[0], -expected.c[1], -expected.c[2]);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) EXPECT_NEAR(mass.inertia(i, j), expected.I[4 * i + j], kShare * scale) << i << ' ' << j;
}

template <class ShapeKind>
void expectOdesMass(const ShapeKind &shape) {
    const Pose pose = drawnPose();
    const double density = drawn(1, 5000);
    ShapeMass sum;
    sum.add(collisionOf(shape, pose), density);
    ASSERT_TRUE(sum.total());
    expectSame(*sum.total(), placed(odesMass(shape, density), pose));
}

TEST(ShapeMass, IsOdes) {
    for (int i = 0; i < 20; ++i) {
        SCOPED_TRACE(i);
        expectOdesMass(Box{{drawn(0.1, 3), drawn(0.1, 3), drawn(0.1, 3)}});
        expectOdesMass(Sphere{drawn(0.1, 3)});
        expectOdesMass(Cylinder{drawn(0.1, 3), drawn(0.1, 3)});
        expectOdesMass(Capsule{drawn(0.1, 3), drawn(0.1, 3)});
    }
}

TEST(ShapeMass, OfSeveralIsTheSum) {
    const Box box{{1, 2, 0.5}};
    const Capsule capsule{0.4, 1};
    const Pose first = drawnPose(), second = drawnPose();
    ShapeMass sum;
    sum.add(collisionOf(box, first), 700);
    sum.add(collisionOf(capsule, second), 2710);
    dMass expected = placed(odesMass(box, 700), first);
    const dMass other = placed(odesMass(capsule, 2710), second);
    dMassAdd(&expected, &other);
    ASSERT_TRUE(sum.total());
    expectSame(*sum.total(), expected);
}

// A box with a corner at the origin.
TriangleMesh boxMesh(const Vector3 &size, bool isOutwards) {
    TriangleMesh mesh;
    for (int corner = 0; corner < 8; ++corner)
        for (const double at : {(corner & 1) * size.x, (corner >> 1 & 1) * size.y, (corner >> 2) * size.z}) mesh.vertices.push_back(float(at));
    const std::uint32_t faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto &face : faces)
        for (const int corner : {0, 1, 2, 0, 2, 3}) mesh.triangles.push_back(face[isOutwards ? corner : (4 - corner) % 4]);
    return mesh;
}

TEST(ShapeMass, OfAMeshIsThatOfWhatItEncloses) {
    for (const bool isOutwards : {true, false}) {
        const Vector3 size{1, 0.5, 2};
        Pose pose = drawnPose();
        ShapeMass sum;
        sum.add(collisionOf(boxMesh(size, isOutwards), pose), 800);
        pose.position += pose.rotation * (0.5 * size);
        ASSERT_TRUE(sum.total());
        expectSame(*sum.total(), placed(odesMass(Box{size}, 800), pose));
    }
}

TEST(ShapeMass, IsNoneWithoutAVolume) {
    const auto isThere = [](const Shape &shape) {
        ShapeMass sum;
        sum.add(collisionOf(shape), 1000);
        return sum.total().has_value();
    };
    EXPECT_FALSE(ShapeMass().total());
    EXPECT_FALSE(isThere(Plane{{0, 0, 1}}));
    EXPECT_FALSE(isThere(HeightField{2, 2, {0, 1, 2, 3}, 1, 1}));
    EXPECT_FALSE(isThere(TriangleMesh{}));
    TriangleMesh open = boxMesh({1, 1, 1}, true);
    EXPECT_TRUE(isThere(open));
    open.triangles.resize(33);
    EXPECT_FALSE(isThere(open));
    EXPECT_FALSE(isThere(boxMesh({1, 1, 0}, true))) << "flat";
    EXPECT_FALSE(isThere(Box{{1e-8, 1e-8, 1e-9}})) << "too light";
    EXPECT_FALSE(isThere(Box{{1e9, 1e9, 1e9}})) << "too heavy";
}

std::string linked(const std::string &inertial, const std::string &collisions, const std::string &version = "1.11") {
    return "<sdf version=\"" + version + "\"><world name=\"w\"><model name=\"m\"><link name=\"link\">" + inertial + collisions +
           "</link></model></world></sdf>";
}
std::string cube(const std::string &name, const std::string &pose, const std::string &density = "") {
    return "<collision name=\"" + name + "\"><pose>" + pose + "</pose>" + density + "<geometry>" + box(1, 1, 1) + "</geometry></collision>";
}
dMass massOf(const SdfScene &scene) { return small_world::massOf(body(scene, "m::link")); }

TEST(AutomaticInertial, IsThatOfTheCollisions) {
    const auto scene = load(linked("<inertial auto=\"true\"/>", cube("a", "0 0 1 0 0 0") + cube("b", "0 0 3 0 0 0", "<density>3000</density>")));
    const dMass mass = massOf(*scene);
    EXPECT_DOUBLE_EQ(mass.mass, 4000);
    EXPECT_NEAR(position(body(*scene, "m::link")).z, 2.5, 1e-6);
    EXPECT_NEAR(mass.I[0], 4000. / 6 + 1000 * 1.5 * 1.5 + 3000 * 0.5 * 0.5, 1e-3);
    EXPECT_NEAR(mass.I[10], 4000. / 6, 1e-3);
}

// What is written of the centre and the matrix does not count, and a mass scales them.
TEST(AutomaticInertial, HasTheMassThatIsWritten) {
    const auto scene =
        load(linked("<inertial auto=\"1\"><mass>6</mass><pose>5 5 5 0 0 0</pose><inertia><ixx>9</ixx><iyy>9</iyy><izz>9</izz></inertia>"
                    "</inertial>",
                    cube("a", "0 0 1 0 0 0")));
    EXPECT_DOUBLE_EQ(massOf(*scene).mass, 6);
    EXPECT_NEAR(massOf(*scene).I[0], 1, 1e-6);
    EXPECT_NEAR(position(body(*scene, "m::link")).z, 1, 1e-6);
}

TEST(AutomaticInertial, HasTheLinksDensityWhereAShapeHasNone) {
    const std::string both = cube("a", "0 0 0 0 0 0") + cube("b", "0 0 2 0 0 0", "<density>30</density>");
    EXPECT_DOUBLE_EQ(massOf(*load(linked("<inertial auto=\"true\"><density>20</density></inertial>", both))).mass, 50);
    EXPECT_DOUBLE_EQ(massOf(*load(linked("<inertial auto=\"false\"><density>20</density></inertial>", both))).mass, 1);
    EXPECT_DOUBLE_EQ(massOf(*load(linked("<inertial><density>20</density></inertial>", both))).mass, 1);
}

TEST(AutomaticInertial, NeedsAVolume) {
    const std::string nothing = linked("<inertial auto=\"true\"/>", "");
    expectError(nothing, LoadError::Kind::Unsupported,
                {"test.sdf: /sdf/world/model[m]/link[link]/inertial: auto=\"true\" without a collision that has a volume"});
    const Loaded loaded = loadWithWarnings(nothing, true);
    EXPECT_EQ(loaded.warnings.size(), 1u);
    EXPECT_DOUBLE_EQ(massOf(*loaded.scene).mass, 1);
    EXPECT_NO_THROW(
        load("<sdf version=\"1.11\"><world name=\"w\"><model name=\"m\"><static>1</static><link name=\"link\"><inertial auto=\"true\"/></link>"
             "</model></world></sdf>"));
}

TEST(AutomaticInertial, IsOfVersion1_11) {
    EXPECT_NO_THROW(load(linked("<inertial auto=\"true\"/>", cube("a", "0 0 0 0 0 0"), "1.12")));
    EXPECT_THROW(load(linked("<inertial auto=\"true\"/>", cube("a", "0 0 0 0 0 0"), "1.10")), LoadError);
    EXPECT_THROW(load(linked("<inertial auto=\"perhaps\"/>", cube("a", "0 0 0 0 0 0"))), LoadError);
    EXPECT_THROW(load(linked("<inertial auto=\"true\"><density>0</density></inertial>", cube("a", "0 0 0 0 0 0"))), LoadError);
}

}  // namespace
