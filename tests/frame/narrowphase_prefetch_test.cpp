// Narrow-phase prefetch: workers compute contacts before their callbacks, dCollide returns them, and what is not asked
// for stays little. That they are the right ones is the exactness suite's.
//
// Covers dxSpaceCollision.cpp.
#include <gtest/gtest.h>
#include <ode/ode.h>
#include <sys/mman.h>
#include <unistd.h>

#include <csignal>

#include "support/child_run.h"
#include "HeapWorld.h"
#include "OdeSession.h"

namespace {

struct Counts {
    unsigned shared = dODE_MT_GetSharedCollisions();
    unsigned ahead = dODE_MT_GetContactsAhead();
    unsigned unused = dODE_MT_GetContactsAheadUnused();

    Counts since(const Counts &before) const {
        Counts difference;
        difference.shared = shared - before.shared;
        difference.ahead = ahead - before.ahead;
        difference.unused = unused - before.unused;
        return difference;
    }
};

class NarrowphasePrefetch : public testing::TestWithParam<dSpaceID (*)(dSpaceID)> {
protected:
    Counts run(int frames, HeapWorld::Callback callback = nullptr) {
        dRandSetSeed(0);
        HeapWorld world(GetParam()(nullptr));
        world.setCallback(callback);
        const Counts before;
        for (int i = 0; i < frames; ++i) {
            world.collide();
            world.step();
        }
        positions = world.positions();
        contacts = world.contacts();
        return Counts().since(before);
    }

    OdeSession session{3, "lcp"};
    std::vector<dReal> positions;
    int contacts = 0;
};

TEST_P(NarrowphasePrefetch, WorkersComputeThemAndCallbacksGetThem) {
    const Counts counts = run(40);
    EXPECT_GT(contacts, 40 * HeapWorld::kSide);
    EXPECT_GE(counts.shared, 1u);  // a worker may be late for most, where others use the cores
    EXPECT_GT(counts.ahead, 40u * HeapWorld::kSide);
    EXPECT_EQ(counts.unused, 0u);
}

TEST_P(NarrowphasePrefetch, NotOnOneThread) {
    OdeSession::use(1, "lcp");
    EXPECT_EQ(run(5).ahead, 0u);
    OdeSession::use(3, "serial");
    EXPECT_EQ(run(5).ahead, 0u);
}

TEST_P(NarrowphasePrefetch, TheWorldMovesAsWithoutThem) {
    run(40);
    const std::vector<dReal> shared = positions;
    OdeSession::use(0, "auto");
    run(40);
    EXPECT_EQ(shared, positions);
}

// Without a call of dCollide the flags are unknown; with one call in a frame they are known, but little else is asked for.
TEST_P(NarrowphasePrefetch, LittleIsComputedForCallbacksThatDoNotAsk) {
    EXPECT_EQ(run(20, [](HeapWorld &, dGeomID, dGeomID) {}).ahead, 0u);
    const Counts counts = run(60, [](HeapWorld &world, dGeomID o1, dGeomID o2) {
        static unsigned calls = 0;
        if (++calls % 16 == 0) world.makeContacts(o1, o2);
    });
    EXPECT_GT(counts.ahead, 0u);
    EXPECT_LT(counts.unused, 4u * 256u);  // dxNarrowphasePrefetch stops after some 256 pairs, and for longer each time
}

// A convex geom whose points are nowhere: a program may keep one for its box, and never collide it.
class Sensor {
public:
    explicit Sensor(dSpaceID space) {
        for (int i = 0; i < 8; ++i)
            for (int axis = 0; axis < 3; ++axis) points()[3 * i + axis] = (i >> axis & 1) != 0 ? 30 : -30;
        for (int i = 0; i < 4; ++i) planes()[i] = i == 2 ? 1 : 30 * (i == 3);
        m_geom = dCreateConvex(space, planes(), 1, points(), 8, kPolygon);
        dReal box[6];
        dGeomGetAABB(m_geom, box);
        mprotect(m_page, kSize, PROT_NONE);
    }
    ~Sensor() {
        mprotect(m_page, kSize, PROT_READ | PROT_WRITE);
        munmap(m_page, kSize);
    }
    Sensor(const Sensor &) = delete;
    Sensor &operator=(const Sensor &) = delete;

private:
    static constexpr std::size_t kSize = 4096;
    static constexpr unsigned kPolygon[] = {4, 4, 5, 7, 6};  // the upper face

    dReal *points() const { return static_cast<dReal *>(m_page); }
    dReal *planes() const { return points() + 3 * 8; }

    void *const m_page = mmap(nullptr, kSize, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    dGeomID m_geom;
};

// Nor are contacts computed by the colliders that read its points.
TEST_P(NarrowphasePrefetch, NothingIsComputedForGeomsThatAreNeverCollided) {
    const dSpaceID space = GetParam()(nullptr);
    Sensor sensor(space);
    HeapWorld world(space);
    world.setCallback([](HeapWorld &heap, dGeomID o1, dGeomID o2) {
        if (dGeomGetClass(o1) != dConvexClass && dGeomGetClass(o2) != dConvexClass) heap.makeContacts(o1, o2);
    });
    const Counts before;
    for (int i = 0; i < 20; ++i) {
        world.collide();
        world.step();
    }
    const Counts counts = Counts().since(before);
    EXPECT_GT(counts.ahead, 20u * HeapWorld::kSide);
    EXPECT_EQ(counts.unused, 0u);
}

// A cylinder and a capsule so long that libccd never finds out how they overlap, and a program that does not ask.
class LongPair {
public:
    explicit LongPair(dSpaceID space)
        : m_cylinder(dCreateCylinder(space, 2.09454, kLength)), m_capsule(dCreateCapsule(space, 4.94066e-324, kLength)) {
        dGeomSetPosition(m_cylinder, 0.25999030775004711, -0.23197211160150816, -0.72142411169165999);
        dGeomSetPosition(m_capsule, 0.92362928071389172, 0.41130943611133308, 0.56265386389853689);
        dGeomSetRotation(m_capsule, kTurned);
    }

    void collide() const {
        dContactGeom contacts[4];
        dCollide(m_capsule, m_cylinder, 4, contacts, sizeof contacts[0]);
    }

private:
    static constexpr dReal kLength = 1e20;
    static constexpr dMatrix3 kTurned = {0.86494081160245639,  -0.36226692259906523, 0.34733279317548899,  0,
                                         -0.50183612174396419, -0.6327813552769741,  0.58970184273649118,  0,
                                         0.0061562437785762092, -0.68436133234165053, -0.72911704647340403, 0};

    dGeomID m_cylinder, m_capsule;
};

bool isLong(dGeomID geom) { return dGeomGetClass(geom) == dCylinderClass || dGeomGetClass(geom) == dCapsuleClass; }

// Both are collided with the balls.
TEST_P(NarrowphasePrefetch, NoWaitForAPairThatIsNotRequested) {
    const support::Ending asked = support::runInChild([] {
        alarm(1);
        LongPair(nullptr).collide();
    });
    EXPECT_TRUE(asked.killedBy(SIGALRM)) << "libccd comes to an end";
    EXPECT_TRUE(support::trueInChild([] {
        OdeSession::use(3, "lcp");
        const dSpaceID space = GetParam()(nullptr);
        LongPair pair(space);
        HeapWorld world(space);
        world.setCallback([](HeapWorld &heap, dGeomID o1, dGeomID o2) {
            const bool hasBall = dGeomGetClass(o1) == dSphereClass || dGeomGetClass(o2) == dSphereClass;
            if ((!isLong(o1) && !isLong(o2)) || hasBall) heap.makeContacts(o1, o2);
        });
        const Counts before;
        for (int i = 0; i < 20; ++i) {
            world.collide();
            world.step();
        }
        return Counts().since(before).ahead > 20u * HeapWorld::kSide;
    }));
}

TEST_P(NarrowphasePrefetch, OtherCallsAreComputed) {
    const Counts counts = run(20, [](HeapWorld &world, dGeomID o1, dGeomID o2) {
        dContactGeom first[2], swapped[2], again[2];
        const int count = dCollide(o1, o2, 2, first, sizeof(dContactGeom));
        EXPECT_EQ(dCollide(o2, o1, 2, swapped, sizeof(dContactGeom)) > 0, count > 0);
        ASSERT_EQ(dCollide(o1, o2, 2, again, sizeof(dContactGeom)), count);
        for (int i = 0; i < count; ++i) {
            EXPECT_EQ(first[i].depth, again[i].depth);
            EXPECT_EQ(first[i].g1, o1);
            EXPECT_EQ(first[i].g2, o2);
            EXPECT_EQ(swapped[i].g1, o2);
        }
        world.makeContacts(o1, o2);
    });
    EXPECT_GT(counts.ahead, 0u);
}

dSpaceID createQuadTree(dSpaceID parent) {
    const dVector3 centre = {0, 0, 0}, extents = {10, 10, 10};
    return dQuadTreeSpaceCreate(parent, centre, extents, 3);
}

constexpr const char *kSpaceNames[] = {"simple", "hash", "quadtree", "sweep"};

INSTANTIATE_TEST_SUITE_P(Spaces, NarrowphasePrefetch,
                         testing::Values(dSimpleSpaceCreate, dHashSpaceCreate, createQuadTree, createSweepSpace),
                         [](const auto &info) { return kSpaceNames[info.index]; });

}  // namespace
