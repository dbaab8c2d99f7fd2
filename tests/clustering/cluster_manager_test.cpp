// dxClusterManager: which spaces have clusters, when, and that each has its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "ClusteredSpace.h"
#include "CrossoverPasses.h"

namespace {

std::string passOf(dSpaceID space) {
    const dxClusteredWorldAndSpace *const clustered = dxClusterManager::find(space);
    return clustered != nullptr ? clustered->passName() : "none";
}

TEST(ClusterManager, PassesAreKnownByTheirNames) {
    for (const char *name : kPasses) {
        const auto pass = dxMakeCrossoverPass(name);
        ASSERT_NE(pass, nullptr) << name;
        EXPECT_STREQ(pass->name(), name);
    }
    EXPECT_EQ(dxMakeCrossoverPass("kmeans"), nullptr);
    EXPECT_EQ(dxMakeCrossoverPass(""), nullptr);
}

TEST(ClusterManager, ASpaceHasTheClustersOfTheAlgorithmInForceWhenItCollides) {
    ClusteredSpace world("auto");
    world.robot(0, 0, 0);
    world.robot(0, 0, dReal(0.5));
    EXPECT_EQ(passOf(world.space()), "none");
    for (const char *pass : kPasses) {
        OdeSession::use(0, pass);
        EXPECT_EQ(world.collide(), 1u);
        EXPECT_EQ(passOf(world.space()), pass);
    }
    for (const char *other : {"auto", "serial", "lcp"}) {
        OdeSession::use(0, "original");
        world.collide();
        OdeSession::use(0, other);
        EXPECT_EQ(world.collide(), 1u);
        EXPECT_EQ(passOf(world.space()), "none") << other;
    }
}

TEST(ClusterManager, ClustersStayAsLongAsTheAlgorithm) {
    ClusteredSpace world("original");
    world.robot(0, 0, 0);
    world.robot(9, 0, 0);
    world.collide();
    const auto *const clustered = dxClusterManager::find(world.space());
    world.collide();
    EXPECT_EQ(dxClusterManager::find(world.space()), clustered);
}

// Any number of worlds and spaces, also two spaces of one world, also nested ones that the user collides.
TEST(ClusterManager, EverySpaceHasItsOwn) {
    ClusteredSpace a("decluster"), b("decluster", dSimpleSpaceCreate);
    a.robot(0, 0, 0);
    a.robot(50, 0, 0);
    a.robot(100, 0, 0);
    b.robot(0, 0, 0);
    b.robot(0, 0, 30);
    EXPECT_EQ(dxClusterManager::find(b.space()), nullptr) << "not yet";
    a.collide();
    b.collide();
    EXPECT_EQ(a.clusters().count(), 3);
    EXPECT_EQ(b.clusters().count(), 2);
    const dSpaceID nested = dSimpleSpaceCreate(a.space());
    dCreateSphere(nested, 1);
    dSpaceCollide(nested, nullptr, [](void *, dGeomID, dGeomID) {});
    EXPECT_NE(dxClusterManager::find(nested), nullptr);
    EXPECT_NE(dxClusterManager::find(nested), dxClusterManager::find(a.space()));
}

// No copies, no hidden worlds and spaces: what a callback sees is what the program made.
TEST(ClusterManager, HandlesInACallbackAreTheUsersOwn) {
    for (const char *pass : kPasses) {
        ClusteredSpace world(pass);
        dGeomID made[] = {world.robot(0, 0, 0), world.robot(0, 0, dReal(0.5)), world.wall(0, 0, 0, 3), world.floor(0)};
        struct Check {
            ClusteredSpace &world;
            dGeomID *made;
            int calls;
        } check{world, made, 0};
        dSpaceCollide(world.space(), &check, [](void *data, dGeomID a, dGeomID b) {
            Check &seen = *static_cast<Check *>(data);
            ++seen.calls;
            for (const dGeomID geom : {a, b}) {
                EXPECT_NE(std::find(seen.made, seen.made + 4, geom), seen.made + 4);
                EXPECT_EQ(dGeomGetSpace(geom), seen.world.space());
                if (dGeomGetBody(geom) != nullptr) {
                    EXPECT_EQ(dBodyGetWorld(dGeomGetBody(geom)), seen.world.world());
                }
            }
        });
        EXPECT_EQ(check.calls, 6) << pass;
    }
}

TEST(ClusterManager, SpacesOfAllKindsHaveThem) {
    OdeSession session(0, "decluster");
    const dVector3 centre = {0, 0, 0}, extents = {10, 10, 10};
    for (const dSpaceID space : {dSimpleSpaceCreate(nullptr), dHashSpaceCreate(nullptr),
                                 dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ),
                                 dQuadTreeSpaceCreate(nullptr, centre, extents, 3)}) {
        dCreateSphere(space, 1);
        dCreateSphere(space, 1);
        std::size_t pairs = 0;
        dSpaceCollide(space, &pairs, [](void *count, dGeomID, dGeomID) { ++*static_cast<std::size_t *>(count); });
        EXPECT_EQ(pairs, 1u);
        EXPECT_NE(dxClusterManager::find(space), nullptr) << "kind " << dSpaceGetClass(space);
        dSpaceDestroy(space);
    }
}

// A callback that collides the space it is called for is answered as by upstream, and changes no clusters.
TEST(ClusterManager, ALockedSpaceKeepsWhatItHas) {
    ClusteredSpace world("original");
    world.robot(0, 0, 0);
    world.robot(0, 0, dReal(0.5));
    dSpaceCollide(world.space(), &world, [](void *data, dGeomID, dGeomID) {
        ClusteredSpace &self = *static_cast<ClusteredSpace *>(data);
        OdeSession::use(0, "decluster");
        dxClusterManager::prepare(self.space(), "decluster");
        EXPECT_EQ(passOf(self.space()), "original");
    });
    world.collide();
    EXPECT_EQ(passOf(world.space()), "decluster");
}

}  // namespace
