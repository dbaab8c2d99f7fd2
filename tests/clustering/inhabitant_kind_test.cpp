// dxKindOf, and that the kind of a member follows its bodies at run time.
#include <gtest/gtest.h>

#include "ClusteredSpace.h"
#include "clusters/dxInhabitantLinks.h"

namespace {

using Kind = dxClusterScene::Kind;

class InhabitantKind : public testing::Test {
protected:
    Kind seenKindOf(dGeomID geom) { return world.clustered().scene()[slotOf(geom)].kind; }
    dGeomID nestedIn(dSpaceID outer, dSpaceID (*create)(dSpaceID) = dSimpleSpaceCreate) {
        return reinterpret_cast<dGeomID>(create(outer));
    }
    static dSpaceID asSpace(dGeomID geom) { return reinterpret_cast<dSpaceID>(geom); }
    dGeomID with(dGeomID geom) {
        dGeomSetBody(geom, dBodyCreate(world.world()));
        return geom;
    }

    ClusteredSpace world{"decluster"};
    dGeomID other = world.robot(20, 0, 0);  // so that the space is never alone with one geom
};

TEST_F(InhabitantKind, AGeomIsDynamicIfItHasABody) {
    EXPECT_EQ(dxKindOf(world.robot(0, 0, 0)), Kind::dynamicGeom);
    EXPECT_EQ(dxKindOf(world.wall(0, 0, 0, 1)), Kind::staticGeom);
    EXPECT_EQ(dxKindOf(world.floor(0)), Kind::staticGeom);
}

TEST_F(InhabitantKind, ASpaceIsDynamicIfAGeomInItHasABodyHoweverDeep) {
    const dGeomID outer = nestedIn(world.space());
    EXPECT_EQ(dxKindOf(outer), Kind::staticGeom) << "empty";
    const dGeomID first = nestedIn(asSpace(outer)), second = nestedIn(asSpace(outer));
    const dGeomID inner = nestedIn(asSpace(first));
    dCreateSphere(asSpace(inner), 1);
    dCreateSphere(asSpace(second), 1);
    EXPECT_EQ(dxKindOf(outer), Kind::staticGeom);
    const dGeomID deep = with(dCreateSphere(asSpace(inner), 1));
    EXPECT_EQ(dxKindOf(outer), Kind::dynamicGeom);
    EXPECT_EQ(dxKindOf(first), Kind::dynamicGeom);
    EXPECT_EQ(dxKindOf(second), Kind::staticGeom) << "a neighbour's body is not its own";
    dGeomSetBody(deep, nullptr);
    EXPECT_EQ(dxKindOf(outer), Kind::staticGeom);
}

TEST_F(InhabitantKind, FollowsABodySetOrTakenAway) {
    const dGeomID geom = world.wall(0, 0, 0, 1);
    world.collide();
    EXPECT_EQ(seenKindOf(geom), Kind::staticGeom);
    with(geom);
    world.collide();
    EXPECT_EQ(seenKindOf(geom), Kind::dynamicGeom);
    dGeomSetBody(geom, nullptr);  // which moves nothing
    world.collide();
    EXPECT_EQ(seenKindOf(geom), Kind::staticGeom);
    EXPECT_FALSE(world.isClustered(geom));
}

TEST_F(InhabitantKind, FollowsABodyDestroyed) {
    const dGeomID geom = world.robot(0, 0, 0);
    world.collide();
    dBodyDestroy(dGeomGetBody(geom));
    world.collide();
    EXPECT_EQ(seenKindOf(geom), Kind::staticGeom);
}

TEST_F(InhabitantKind, FollowsWhatHappensInNestedSpacesOfAnyType) {
    for (dSpaceID (*const create)(dSpaceID) : {dSimpleSpaceCreate, dHashSpaceCreate}) {
        const dGeomID outer = nestedIn(world.space()), inner = nestedIn(asSpace(outer), create);
        const dGeomID geom = dCreateSphere(asSpace(inner), 1);
        dCreateSphere(asSpace(inner), 1);
        world.collide();
        EXPECT_EQ(seenKindOf(outer), Kind::staticGeom);
        with(geom);
        world.collide();
        EXPECT_EQ(seenKindOf(outer), Kind::dynamicGeom);
        dGeomSetBody(geom, nullptr);
        world.collide();
        EXPECT_EQ(seenKindOf(outer), Kind::staticGeom);
        const dGeomID late = with(dCreateSphere(nullptr, 1));
        dSpaceAdd(asSpace(inner), late);
        world.collide();
        EXPECT_EQ(seenKindOf(outer), Kind::dynamicGeom) << "a geom with a body is added";
        dGeomDestroy(late);
        world.collide();
        EXPECT_EQ(seenKindOf(outer), Kind::staticGeom) << "and destroyed";
    }
}

TEST_F(InhabitantKind, FollowsBodiesInASweepAndPruneSpaceWithin) {
    const dSpaceID sap = dSweepAndPruneSpaceCreate(world.space(), dSAP_AXES_XYZ);
    const dGeomID geom = dCreateSphere(sap, 1);
    world.collide();
    EXPECT_EQ(seenKindOf(reinterpret_cast<dGeomID>(sap)), Kind::staticGeom);
    with(geom);
    world.collide();
    EXPECT_EQ(seenKindOf(reinterpret_cast<dGeomID>(sap)), Kind::dynamicGeom);
    dGeomSetBody(geom, nullptr);
    world.collide();
    EXPECT_EQ(seenKindOf(reinterpret_cast<dGeomID>(sap)), Kind::staticGeom);
}

}  // namespace
