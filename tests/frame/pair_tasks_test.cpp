// Callbacks of one body never run at the same time under "concurrent", wherever its geoms are; and cutting the pairs into
// tasks writes to no body, since two threads of the user may collide spaces with geoms of the same bodies.
//
// Covers dxConcurrentColliders.cpp.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <atomic>
#include <chrono>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "Deadline.h"
#include "OdeSession.h"
#include "SphereRows.h"

#include "config.h"
#include "objects.h"

namespace {

class ConcurrentSession {
public:
    ConcurrentSession() { dODE_MT_SetCallbackPolicy("concurrent"); }
    ~ConcurrentSession() { dODE_MT_SetCallbackPolicy("serial"); }

private:
    OdeSession m_session{4, "lcp"};
};

// Robots in a row. Each has one body with several geoms: in the space itself, and in spaces nested in it; each geom touches
// a ball of its own, so that it has a pair of its own.
class Robots {
public:
    static constexpr int kRobots = 12;

    explicit Robots(std::vector<int> depths) : m_space(dHashSpaceCreate(nullptr)), m_busy(kRobots) {
        for (int robot = 0; robot < kRobots; ++robot) {
            const dBodyID body = dBodyCreate(m_world);
            dBodySetData(body, &m_busy[robot]);
            for (std::size_t limb = 0; limb < depths.size(); ++limb) {
                const dReal x = 100.0 * robot, y = 10.0 * limb;
                const dGeomID geom = dCreateSphere(nested(depths[limb]), 1);
                dGeomSetBody(geom, body);
                dGeomSetOffsetPosition(geom, x, y, 0);
                dGeomSetPosition(addBall(), x, y + 1, 0);
            }
        }
    }
    ~Robots() {
        dSpaceDestroy(m_space);
        dWorldDestroy(m_world);
    }

    // How many callbacks were made; how many of them while another one of the same body was running.
    struct Count {
        std::atomic<int> callbacks{0}, clashes{0};
    };
    void collide(Count &count) const { dSpaceCollide(m_space, &count, meet); }

private:
    // A space of its own for each geom, so that the pairs are those of different geoms.
    dSpaceID nested(int depth) const {
        dSpaceID space = m_space;
        for (int i = 0; i < depth; ++i) space = dSimpleSpaceCreate(space);
        return space;
    }

    dGeomID addBall() const {
        const dGeomID ball = dCreateSphere(m_space, 0.5);
        dGeomSetBody(ball, dBodyCreate(m_world));
        return ball;
    }

    static void meet(void *data, dGeomID o1, dGeomID o2) {
        if (dGeomIsSpace(o1) || dGeomIsSpace(o2)) {
            dSpaceCollide2(o1, o2, data, meet);
            return;
        }
        for (const dGeomID geom : {o1, o2}) {
            auto *const busy = static_cast<std::atomic<int> *>(dBodyGetData(dGeomGetBody(geom)));
            if (busy == nullptr) continue;
            Count &count = *static_cast<Count *>(data);
            ++count.callbacks;
            if (++*busy > 1) ++count.clashes;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            --*busy;
        }
    }

    dWorldID m_world = dWorldCreate();
    dSpaceID m_space;
    std::vector<std::atomic<int>> m_busy;  // by robot: callbacks of its body that are running
};

void expectNoClash(const std::vector<int> &depths) {
    const ConcurrentSession session;
    const Robots robots(depths);
    const unsigned before = dODE_MT_GetParallelCollisions();
    for (int frame = 0; frame < 5; ++frame) {
        Robots::Count count;
        robots.collide(count);
        EXPECT_EQ(count.callbacks, Robots::kRobots * static_cast<int>(depths.size()));
        EXPECT_EQ(count.clashes, 0);
    }
    EXPECT_GT(dODE_MT_GetParallelCollisions(), before) << "robots are independent of each other";
}

TEST(PairTasks, GeomsOfABodyInTheSpace) { expectNoClash({0, 0, 0}); }
TEST(PairTasks, AGeomInANestedSpace) { expectNoClash({0, 1}); }
TEST(PairTasks, GeomsInSeveralNestedSpaces) { expectNoClash({1, 1, 1}); }
TEST(PairTasks, GeomsInSpacesOfSpaces) { expectNoClash({2, 0, 3, 1}); }

// Upstream's scratch memory in a body (which steps use) is not ours while spaces are collided.
TEST(PairTasks, BodiesAreNotWrittenTo) {
    const ConcurrentSession session;
    const SphereRows rows(dHashSpaceCreate(nullptr));
    std::vector<dBodyID> bodies;
    for (int i = 0; i < dSpaceGetNumGeoms(rows.space()); ++i)
        bodies.push_back(dGeomGetBody(dSpaceGetGeom(rows.space(), i)));
    constexpr int kMark = 12345;
    for (const dBodyID body : bodies) body->tag = kMark;
    dSpaceCollide(rows.space(), nullptr, [](void *, dGeomID, dGeomID) {});
    for (const dBodyID body : bodies) EXPECT_EQ(body->tag, kMark);
}

// Geoms without bodies that a collider writes to: callbacks of pairs with them never run at the same time either. Geoms that
// are written to have a flag as their data; those that are one place in memory have the same. What is written to is in a pair
// with a body of its own for each flag, so that there are many pairs that only the flag holds together.
class WrittenGeoms {
public:
    explicit WrittenGeoms(const char *policy) { dODE_MT_SetCallbackPolicy(policy); }
    ~WrittenGeoms() {
        dSpaceDestroy(m_space);
        if (m_shared != nullptr) dGeomDestroy(m_shared);
        dWorldDestroy(m_world);
        dGeomHeightfieldDataDestroy(m_heights);
        dODE_MT_SetCallbackPolicy("serial");
    }

    dSpaceID space() const { return m_space; }

    // Its heights come from a function of the program's, so that upstream collides it in place.
    dGeomID addTerrain(dSpaceID space) {
        dGeomHeightfieldDataBuildCallback(m_heights, nullptr, [](void *, int, int) -> dReal { return 0; }, 100, 100, 11, 11, 1, 0, 1, 0);
        dGeomHeightfieldDataSetBounds(m_heights, -1, 0.1);  // below what lies on the stones
        return dCreateHeightfield(space, m_heights, 1);
    }
    void addStones() {
        for (int i = 0; i < kStones; ++i) addMet(dCreateSphere(m_space, 1), 6.0 * i - 30, &m_busy[i]);
    }
    // Two at a time have a geom in common that is put into their place.
    void addTransforms() {
        m_shared = dCreateSphere(nullptr, 1);
        for (int i = 0; i < kStones; ++i) {
            const dGeomID transform = dCreateGeomTransform(m_space);
            dGeomTransformSetGeom(transform, m_shared);
            addMet(transform, 6.0 * i - 30, &m_busy[0]);
        }
    }
    // Height fields with the same samples, each under a stone of its own: neighbours do not touch.
    void addTerraces() {
        dGeomHeightfieldDataBuildCallback(m_heights, nullptr, [](void *, int, int) -> dReal { return 0; }, 4, 4, 3, 3, 1, 0, 1, 0);
        for (int i = 0; i < kStones; ++i) {
            const dGeomID terrace = dCreateHeightfield(m_space, m_heights, 1);
            addMet(terrace, 6.0 * i - 30, &m_busy[0]);
        }
    }
    // Pairs that have nothing to do with one another, for other workers.
    void addOthers() {
        for (int i = 0; i < 40; ++i) addMet(dCreateSphere(m_space, 1), 1000.0 + 6 * i, nullptr);
    }

    void expectNoClash() {
        addOthers();
        const unsigned before = dODE_MT_GetParallelCollisions();
        for (int frame = 0; frame < 5; ++frame) dSpaceCollide(m_space, this, meet);
        EXPECT_EQ(m_clashes, 0);
        EXPECT_GT(m_marked, 0);
        EXPECT_GT(dODE_MT_GetParallelCollisions(), before) << "others are independent of each other";
    }

private:
    using Flag = std::atomic<int>;
    static constexpr int kStones = 10;

    void addMet(dGeomID geom, dReal x, Flag *flag) {
        dGeomSetPosition(geom, x, 0, 0);
        dGeomSetData(geom, flag);
        const dGeomID ball = dCreateSphere(m_space, 1);
        dGeomSetBody(ball, dBodyCreate(m_world));
        dGeomSetPosition(ball, x, 1.9, 0);
    }

    static void meet(void *data, dGeomID a, dGeomID b) { static_cast<WrittenGeoms *>(data)->meet(a, b); }
    void meet(dGeomID a, dGeomID b) {
        if (dGeomIsSpace(a) || dGeomIsSpace(b)) return dSpaceCollide2(a, b, this, meet);
        for (const dGeomID geom : {a, b}) {
            Flag *const flag = static_cast<Flag *>(dGeomGetData(geom));
            if (flag == nullptr) continue;
            ++m_marked;
            if (++*flag > 1) ++m_clashes;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            dContactGeom contact;
            dCollide(a, b, 1, &contact, sizeof contact);
            --*flag;
        }
    }

    OdeSession m_session{4, "lcp"};
    dWorldID m_world = dWorldCreate();
    dSpaceID m_space = dHashSpaceCreate(nullptr);
    dHeightfieldDataID m_heights = dGeomHeightfieldDataCreate();
    dGeomID m_shared = nullptr;
    Flag m_busy[kStones] = {}, m_clashes{0}, m_marked{0};
};

class PairTasksByPolicy : public testing::TestWithParam<const char *> {};

TEST_P(PairTasksByPolicy, StonesOnTerrain) {
    WrittenGeoms geoms(GetParam());
    geoms.addTerrain(geoms.space());
    geoms.addStones();
    geoms.expectNoClash();
}

TEST_P(PairTasksByPolicy, StonesOnTerrainInANestedSpace) {
    WrittenGeoms geoms(GetParam());
    geoms.addTerrain(dSimpleSpaceCreate(dSimpleSpaceCreate(geoms.space())));
    geoms.addStones();
    geoms.expectNoClash();
}

TEST_P(PairTasksByPolicy, StonesOnTerrainInATransform) {
    WrittenGeoms geoms(GetParam());
    const dGeomID transform = dCreateGeomTransform(geoms.space());
    dGeomTransformSetCleanup(transform, 1);
    dGeomTransformSetGeom(transform, geoms.addTerrain(nullptr));
    geoms.addStones();
    geoms.expectNoClash();
}

TEST_P(PairTasksByPolicy, TransformsWithOneGeom) {
    WrittenGeoms geoms(GetParam());
    geoms.addTransforms();
    geoms.expectNoClash();
}

TEST_P(PairTasksByPolicy, TerracesWithTheSameSamples) {
    WrittenGeoms geoms(GetParam());
    geoms.addTerraces();
    geoms.expectNoClash();
}

INSTANTIATE_TEST_SUITE_P(Policies, PairTasksByPolicy, testing::Values("concurrent", "independent"),
                         [](const testing::TestParamInfo<const char *> &info) { return std::string(info.param); });

// Two threads collide two spaces, in each of which every body has a geom. (ThreadSanitizer is the judge.)
TEST(PairTasks, TwoSpacesWithGeomsOfTheSameBodies) {
    const ConcurrentSession session;
    const SphereRows rows(dHashSpaceCreate(nullptr));
    const dSpaceID second = dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ);
    for (int i = 0; i < dSpaceGetNumGeoms(rows.space()); ++i)
        dGeomSetBody(dCreateSphere(second, 0.5), dGeomGetBody(dSpaceGetGeom(rows.space(), i)));
    constexpr int kFrames = 50;
    const auto collide = [](dSpaceID space, std::atomic<int> &contacts) {
        for (int i = 0; i < kFrames; ++i)
            dSpaceCollide(space, &contacts, [](void *data, dGeomID o1, dGeomID o2) {
                dContactGeom contact;
                *static_cast<std::atomic<int> *>(data) += dCollide(o1, o2, 1, &contact, sizeof contact);
            });
    };
    std::atomic<int> first{0}, other{0};
    std::thread thread([&] { collide(second, other); });
    collide(rows.space(), first);
    thread.join();
    EXPECT_EQ(first, kFrames * SphereRows::kPairs);
    EXPECT_EQ(other, kFrames * SphereRows::kPairs);
    dSpaceDestroy(second);
}

}  // namespace
