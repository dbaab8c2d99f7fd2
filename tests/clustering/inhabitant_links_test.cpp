// dxInhabitantLinks: geoms of one body and of jointed bodies are linked; the links are queried in every frame.
#include <gtest/gtest.h>

#include "ClusteredSpace.h"
#include "clusters/dxInhabitantLinks.h"
#include "core/dxDisjointSets.h"

namespace {

using Kind = dxClusterScene::Kind;
using Slot = dxMembers::Slot;

class InhabitantLinks : public testing::Test {
protected:
    InhabitantLinks() {
        const dReal centre[3] = {0, 0, 0};
        scene.setGrid(dxClusterGrid(5, 100, centre));
    }
    ~InhabitantLinks() override {
        dSpaceDestroy(owner);
        dWorldDestroy(world);
    }

    dBodyID body() { return dBodyCreate(world); }
    Slot add(dGeomID geom, dBodyID body = nullptr) {
        if (body != nullptr) dGeomSetBody(geom, body);
        const Slot slot = members.add(geom);
        scene.put(slot, dxKindOf(geom), bounds(slot));
        return slot;
    }
    Slot addSphere(dBodyID body = nullptr) { return add(dCreateSphere(owner, 1), body); }
    dJointID join(dBodyID a, dBodyID b) {
        const dJointID joint = dJointCreateHinge(world, nullptr);
        dJointAttach(joint, a, b);
        return joint;
    }
    bool gather() { return links.gather(members, scene); }
    bool linked(Slot a, Slot b) const {
        dxDisjointSets sets;
        sets.reset(members.end());
        dxUniteByLinks(links.all(), sets);
        return sets.find(a) == sets.find(b);
    }
    // Far apart, so that only links can hold them together.
    static dxBounds bounds(Slot slot) {
        const dReal x = dReal(slot) * 10;
        const dReal aabb[6] = {x, x + 1, 0, 1, 0, 1};
        return dxBounds(aabb);
    }

    OdeSession session;
    dWorldID world = dWorldCreate();
    dSpaceID owner = dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ);  // destroys what is left in it
    dxMembers members;
    dxClusterScene scene;
    dxInhabitantLinks links;
};

TEST_F(InhabitantLinks, AllGeomsOfABodyAreLinked) {
    const dBodyID one = body(), two = body();
    const Slot a = addSphere(one), b = addSphere(two), c = addSphere(one), d = addSphere(one);
    EXPECT_TRUE(gather());
    EXPECT_TRUE(linked(a, c));
    EXPECT_TRUE(linked(a, d));
    EXPECT_FALSE(linked(a, b));
    EXPECT_FALSE(gather()) << "nothing new";
}

TEST_F(InhabitantLinks, GeomsOfJointedBodiesAreLinkedAlongTheChain) {
    const dBodyID bodies[] = {body(), body(), body(), body()};
    const Slot slots[] = {addSphere(bodies[2]), addSphere(bodies[0]), addSphere(bodies[1]), addSphere(bodies[3])};
    join(bodies[1], bodies[0]);
    join(bodies[1], bodies[2]);
    gather();
    EXPECT_TRUE(linked(slots[0], slots[1]));
    EXPECT_TRUE(linked(slots[0], slots[2]));
    EXPECT_FALSE(linked(slots[0], slots[3]));
}

TEST_F(InhabitantLinks, JointsMadeAndBrokenAtRunTimeAreSeen) {
    const dBodyID one = body(), two = body();
    const Slot a = addSphere(one), b = addSphere(two);
    gather();
    EXPECT_FALSE(linked(a, b));
    const dJointID joint = join(one, two);
    EXPECT_TRUE(gather());
    EXPECT_TRUE(linked(a, b));
    dJointAttach(joint, one, nullptr);
    EXPECT_TRUE(gather());
    EXPECT_FALSE(linked(a, b));
    dJointAttach(joint, two, one);
    gather();
    EXPECT_TRUE(linked(a, b));
    dJointDestroy(joint);
    gather();
    EXPECT_FALSE(linked(a, b));
}

TEST_F(InhabitantLinks, JointsToTheWorldOrToBodiesElsewhereLinkNothing) {
    const dBodyID one = body(), two = body(), elsewhere = body();
    const Slot a = addSphere(one), b = addSphere(two);
    dGeomSetBody(dCreateSphere(owner, 1), elsewhere);  // no member
    join(one, nullptr);
    join(one, elsewhere);
    join(nullptr, two);
    gather();
    EXPECT_TRUE(links.all().empty());
    EXPECT_FALSE(linked(a, b));
}

TEST_F(InhabitantLinks, ANestedSpaceStandsForTheBodiesInIt) {
    const dBodyID one = body(), two = body(), three = body();
    const dSpaceID robot = dSimpleSpaceCreate(nullptr), arm = dHashSpaceCreate(robot);
    dGeomSetBody(dCreateSphere(robot, 1), one);
    dCreateSphere(robot, 1);
    dGeomSetBody(dCreateSphere(arm, 1), two);
    dGeomSetBody(dCreateSphere(arm, 1), two);
    const Slot space = add(reinterpret_cast<dGeomID>(robot));
    const Slot sameBody = addSphere(two), jointed = addSphere(three), stranger = addSphere(body());
    join(two, three);
    gather();
    EXPECT_TRUE(linked(space, sameBody));
    EXPECT_TRUE(linked(space, jointed));
    EXPECT_FALSE(linked(space, stranger));
    dSpaceDestroy(robot);
}

TEST_F(InhabitantLinks, StaticAndBigMembersAreNotLinked) {
    const dBodyID one = body();
    const Slot a = addSphere(one), wall = addSphere();
    const Slot big = addSphere(one);
    const dReal wide[6] = {-9999, 9999, -9999, 9999, 0, 1};
    scene.put(big, Kind::dynamicGeom, dxBounds(wide));
    gather();
    EXPECT_FALSE(linked(a, wall));
    EXPECT_FALSE(linked(a, big)) << "it is compared with everything anyway";
}

TEST_F(InhabitantLinks, AMemberThatGoesTakesItsLinksAlong) {
    const dBodyID one = body();
    const Slot a = addSphere(one), b = addSphere(one), c = addSphere(one);
    gather();
    const dGeomID geom = members[b].geom;
    scene.remove(b);
    members.remove(b);
    dGeomDestroy(geom);
    EXPECT_TRUE(gather());
    EXPECT_TRUE(linked(a, c));
    EXPECT_FALSE(linked(a, b));
}

}  // namespace
