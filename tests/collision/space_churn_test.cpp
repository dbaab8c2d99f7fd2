// A space through which geoms come and go takes no more memory than at the start, whether or not it collides in
// between, under every way of finding pairs.
#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include "OdeSession.h"
#include "sanitizers.h"

namespace {

struct Way {
    const char *name, *algorithm;
    dSpaceID (*create)(dSpaceID);
    int geoms;
    bool collides;
};

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
            if (GetParam().collides) dSpaceCollide(space, nullptr, [](void *, dGeomID, dGeomID) {});
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
    // A vector that doubles does so in one stretch; a leak shows in each of them.
    std::ptrdiff_t least = std::numeric_limits<std::ptrdiff_t>::max();
    for (int stretch = 0; stretch < 3; ++stretch) {
        const std::ptrdiff_t before = bytesInUse();
        churn(2 * rounds);
        least = std::min(least, bytesInUse() - before);
    }
    // one byte for each geom that was replaced
    EXPECT_LT(least, 2 * rounds * GetParam().geoms / 5);
}

INSTANTIATE_TEST_SUITE_P(Ways, SpaceChurn,
                         testing::Values(Way{"dense", "auto", dSimpleSpaceCreate, 100, true},
                                         Way{"neighbours", "auto", dSimpleSpaceCreate, 600, true},
                                         Way{"hash", "auto", dHashSpaceCreate, 100, true},
                                         Way{"sweep", "auto", createSweep, 100, true},
                                         Way{"sweepCrowd", "auto", createSweep, 1200, true},
                                         Way{"sweepUncollided", "auto", createSweep, 100, false},
                                         Way{"original", "original", dHashSpaceCreate, 100, true},
                                         Way{"staticMerged", "static", dHashSpaceCreate, 100, true},
                                         Way{"staticUnmerged", "static-unmerged", dHashSpaceCreate, 100, true},
                                         Way{"duplication", "duplication", dHashSpaceCreate, 100, true},
                                         Way{"decluster", "decluster", dHashSpaceCreate, 100, true},
                                         Way{"simpleUncollided", "auto", dSimpleSpaceCreate, 100, false},
                                         Way{"quadtreeDense", "auto", createQuadTree, 100, true},
                                         Way{"quadtree", "auto", createQuadTree, 600, true},
                                         Way{"hashUncollided", "auto", dHashSpaceCreate, 100, false},
                                         Way{"quadtreeUncollided", "auto", createQuadTree, 100, false}),
                         [](const auto &info) { return std::string(info.param.name); });

}  // namespace
