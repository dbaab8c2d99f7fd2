// What comes before a step asks for the memory that upstream asks for, in the same order, and finds islands, or groups of them.
#include <gtest/gtest.h>

#include <cstdlib>
#include <ostream>
#include <vector>

#include "config.h"
#include "quickstep.h"
#include "step.h"
#include "util.h"

#include "dynamics/step/islands/dxIslandSearch.h"
#include "random_world.h"

namespace {

std::vector<std::size_t> requests;

void *take(dsizeint size) {
    requests.push_back(size);
    return std::malloc(size);
}

void *shrink(void *block, dsizeint size, dsizeint smaller) {
    requests.insert(requests.end(), {size, smaller});
    return block;
}

void giveBack(void *block, dsizeint size) {
    requests.push_back(size);
    std::free(block);
}

using Preparation = decltype(&dxPrepareStep);

std::vector<std::size_t> requestsOf(Preparation prepare, dmemestimate_fn_t estimate, unsigned seed) {
    requests.clear();
    RandomWorld scene({seed % 17 + 1, seed % 29}, seed);
    const dWorldStepMemoryFunctionsInfo functions = {sizeof functions, take, shrink, giveBack};
    dWorldSetStepMemoryManager(scene.world(), &functions);
    if (seed % 2 == 0) dWorldSetStepMemoryReservationPolicy(scene.world(), nullptr);
    for (int i = 0; i < 3; ++i) {
        dxWorldProcessIslandsInfo info;
        EXPECT_TRUE(prepare(scene.world(), info, dReal(0.01), estimate));
        for (unsigned k = 0; k < 20; ++k) dBodyCreate(scene.world());
    }
    return requests;
}

// Of each island or group.
struct Size {
    unsigned bodies, joints;

    bool operator==(const Size &other) const { return bodies == other.bodies && joints == other.joints; }
};

std::ostream &operator<<(std::ostream &stream, const Size &size) { return stream << size.bodies << " bodies, " << size.joints << " joints"; }

// A world of columns, each an island of bodies that contacts hold together, or ball joints.
class Columns {
public:
    Columns() { dInitODE2(0), m_world = dWorldCreate(); }
    ~Columns() { dWorldDestroy(m_world), dCloseODE(); }
    Columns(const Columns &) = delete;
    Columns &operator=(const Columns &) = delete;

    dBodyID add(int bodies, bool hasBalls) const {
        const dContact contact = {};
        dBodyID last = dBodyCreate(m_world);
        for (int i = 1; i < bodies; ++i) {
            const dBodyID next = dBodyCreate(m_world);
            dJointAttach(hasBalls ? dJointCreateBall(m_world, nullptr) : dJointCreateContact(m_world, nullptr, &contact), last, next);
            last = next;
        }
        return last;
    }

    std::vector<Size> groups(const dxGroupSizes &sizes) const {
        dxWorldProcessIslandsInfo info;
        EXPECT_TRUE(dxPrepareGroups(m_world, info, dReal(0.01), &dxEstimateQuickStepMemoryRequirements, sizes));
        std::vector<Size> all;
        const unsigned *size = info.GetIslandSizes();
        for (std::size_t i = 0; i < info.GetIslandsCount(); ++i, size += 2) all.push_back({size[0], size[1]});
        return all;
    }

private:
    dWorldID m_world;
};

}  // namespace

// Upstream begins with the body that was made last.
TEST(IslandSearch, JoinsIslandsToGroups) {
    const Columns columns;
    for (const int bodies : {3, 3, 2, 3, 3}) columns.add(bodies, false);
    EXPECT_EQ(columns.groups({}), (std::vector<Size>{{3, 2}, {3, 2}, {2, 1}, {3, 2}, {3, 2}}));
    EXPECT_EQ(columns.groups({10, 1}), (std::vector<Size>{{6, 4}, {8, 5}}));
    EXPECT_EQ(columns.groups({100, 1}), (std::vector<Size>{{14, 9}}));
}

TEST(IslandSearch, DoesNotMixContactsAndOtherJointsInAGroup) {
    const Columns columns;
    for (const bool hasBalls : {false, false, true, true, true, false, false}) columns.add(2, hasBalls);
    EXPECT_EQ(columns.groups({100, 6}), (std::vector<Size>{{4, 2}, {4, 2}, {2, 1}, {4, 2}}));
}

TEST(IslandSearch, LeavesAnIslandAloneThatFillsAGroup) {
    const Columns columns;
    for (const int bodies : {2, 60, 2, 2}) columns.add(bodies, false);
    EXPECT_EQ(columns.groups({100, 1}), (std::vector<Size>{{4, 2}, {60, 59}, {2, 1}}));
}

// A callback may push bodies of islands that have yet to be stepped.
TEST(IslandSearch, JoinsNoIslandsWhereABodyHasAMovedCallback) {
    const Columns columns;
    columns.add(2, false);
    dBodySetMovedCallback(columns.add(2, false), [](dBodyID) {});
    EXPECT_EQ(columns.groups({100, 1}), (std::vector<Size>{{2, 1}, {2, 1}}));
}

TEST(IslandSearch, AsksForUpstreamsMemory) {
    dInitODE2(0);
    for (const dmemestimate_fn_t estimate : {&dxEstimateStepMemoryRequirements, &dxEstimateQuickStepMemoryRequirements}) {
        for (unsigned seed = 0; seed < 50; ++seed) {
            const std::vector<std::size_t> upstreams = requestsOf(&dxReallocateWorldProcessContext, estimate, seed);
            EXPECT_FALSE(upstreams.empty());
            EXPECT_EQ(upstreams, requestsOf(&dxPrepareStep, estimate, seed)) << "seed " << seed;
        }
    }
    dCloseODE();
}
