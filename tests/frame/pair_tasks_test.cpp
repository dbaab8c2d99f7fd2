// Callbacks of one body never run at the same time under "concurrent", wherever its geoms are; and cutting the pairs into
// tasks writes to no body, since two threads of the user may collide spaces with geoms of the same bodies.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <atomic>
#include <chrono>
#include <map>
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
