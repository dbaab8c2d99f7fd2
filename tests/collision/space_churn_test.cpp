// A space to which geoms are added and from which they are removed uses no more memory than at the start, for any use in between:
// collided, asked with a ray, asked as a member of another space, only cleaned, or nothing; under every way of finding
// pairs.
//
// Covers dxOrderedSpace.cpp, dxSpaceGeoms.cpp.
#include <gtest/gtest.h>
#include <malloc.h>

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

#include "OdeSession.h"
#include "sanitizers.h"

namespace {

using Use = void (*)(dSpaceID);

struct Way {
    const char *name, *algorithm;
    dSpaceID (*create)(dSpaceID);
    int geoms;
    Use use;  // after each round
};

void countPair(void *pairs, dGeomID, dGeomID) { ++*static_cast<int *>(pairs); }

void collided(dSpaceID space) {
    int pairs = 0;
    dSpaceCollide(space, &pairs, countPair);
}

// Queries the space with a ray through all its geoms.
void asked(dSpaceID space) {
    const dGeomID ray = dCreateRay(nullptr, 100000);
    dGeomRaySet(ray, -1, 3, 0, 1, 0, 0);
    int pairs = 0;
    dSpaceCollide2(ray, reinterpret_cast<dGeomID>(space), &pairs, countPair);
    dGeomDestroy(ray);
    EXPECT_GT(pairs, 0);
}

// Makes it a member of a space in which it collides with a geom.
void nested(dSpaceID space) {
    const dSpaceID outer = dSimpleSpaceCreate(nullptr);
    dSpaceSetCleanup(outer, 0);
    const dGeomID ground = dCreatePlane(outer, 0, 0, 1, 0);
    dSpaceAdd(outer, reinterpret_cast<dGeomID>(space));
    int pairs = 0;
    dSpaceCollide(outer, &pairs, [](void *data, dGeomID a, dGeomID b) { dSpaceCollide2(a, b, data, countPair); });
    dSpaceRemove(outer, reinterpret_cast<dGeomID>(space));
    dGeomDestroy(ground);
    dSpaceDestroy(outer);
    EXPECT_GT(pairs, 0);
}

void cleaned(dSpaceID space) { dSpaceClean(space); }

void leftAlone(dSpaceID) {}

dSpaceID createQuadTree(dSpaceID parent) {
    const dVector3 centre = {1000, 0, 0}, extents = {1000, 10, 10};
    return dQuadTreeSpaceCreate(parent, centre, extents, 6);
}

dSpaceID createSweep(dSpaceID parent) { return dSweepAndPruneSpaceCreate(parent, dSAP_AXES_XZY); }

void PrintTo(const Way &way, std::ostream *out) { *out << way.name; }

class SpaceChurn : public testing::TestWithParam<Way> {
protected:
    ~SpaceChurn() override {
        dSpaceDestroy(space);
        dWorldDestroy(world);
    }

    void SetUp() override {
        if (kAddressSanitizer || kThreadSanitizer) GTEST_SKIP() << "the sanitizer keeps freed memory";
    }

    dGeomID make() {
        const dGeomID geom = dCreateSphere(space, dReal(0.5));
        if (next % 2 == 0) dGeomSetBody(geom, dBodyCreate(world));
        // ever onwards, through ever new cells
        dGeomSetPosition(geom, dReal(next) / 5, dReal(next % 7), 0);
        ++next;
        return geom;
    }
    void destroy(dGeomID geom) {
        if (const dBodyID body = dGeomGetBody(geom)) dBodyDestroy(body);
        dGeomDestroy(geom);
    }
    void churn(int rounds) {
        for (int round = 0; round < rounds; ++round) {
            for (std::size_t i = 0; i < geoms.size(); i += 5) {
                destroy(geoms[i]);
                geoms[i] = make();
            }
            GetParam().use(space);
        }
    }

    static std::ptrdiff_t bytesInUse() {
        const auto heap = mallinfo2();
        return static_cast<std::ptrdiff_t>(heap.uordblks + heap.hblkhd);
    }

    OdeSession session{0, GetParam().algorithm};
    dWorldID world = dWorldCreate();
    dSpaceID space = GetParam().create(nullptr);
    std::vector<dGeomID> geoms;
    int next = 0;
};

TEST_P(SpaceChurn, MemoryStaysWhatItWas) {
    for (int i = 0; i < GetParam().geoms; ++i) geoms.push_back(make());
    const int rounds = 40000 / GetParam().geoms;
    churn(rounds);
    const std::ptrdiff_t before = bytesInUse();
    churn(10 * rounds);
    // A byte for each geom that was replaced: what is kept for each, in a vector too, takes more.
    EXPECT_LT(bytesInUse() - before, 10 * rounds * GetParam().geoms / 5);
}

constexpr Use kUncollided[] = {asked, nested, cleaned, leftAlone};
constexpr const char *kUncollidedNames[] = {"Asked", "Nested", "Cleaned", "LeftAlone"};

INSTANTIATE_TEST_SUITE_P(Collided, SpaceChurn,
                         testing::Values(Way{"dense", "auto", dSimpleSpaceCreate, 100, collided},
                                         Way{"neighbours", "auto", dSimpleSpaceCreate, 600, collided},
                                         Way{"hash", "auto", dHashSpaceCreate, 100, collided},
                                         Way{"sweep", "auto", createSweep, 100, collided},
                                         Way{"sweepCrowd", "auto", createSweep, 1200, collided},
                                         Way{"original", "original", dHashSpaceCreate, 100, collided},
                                         Way{"staticMerged", "static", dHashSpaceCreate, 100, collided},
                                         Way{"staticUnmerged", "static-unmerged", dHashSpaceCreate, 100, collided},
                                         Way{"duplication", "duplication", dHashSpaceCreate, 100, collided},
                                         Way{"decluster", "decluster", dHashSpaceCreate, 100, collided},
                                         Way{"quadtreeDense", "auto", createQuadTree, 100, collided},
                                         Way{"quadtree", "auto", createQuadTree, 600, collided}),
                         [](const auto &info) { return std::string(info.param.name); });

std::vector<Way> uncollided() {
    std::vector<Way> ways;
    for (const Use use : kUncollided)
        for (const Way &kind : {Way{"simple", "auto", dSimpleSpaceCreate, 100, use},
                                Way{"hash", "auto", dHashSpaceCreate, 100, use},
                                Way{"sweep", "auto", createSweep, 100, use},
                                Way{"quadtree", "auto", createQuadTree, 100, use}})
            ways.push_back(kind);
    return ways;
}

INSTANTIATE_TEST_SUITE_P(Uncollided, SpaceChurn, testing::ValuesIn(uncollided()), [](const auto &info) {
    return std::string(info.param.name) + kUncollidedNames[info.index / 4];
});

}  // namespace
