// Memory after many frames in which bodies, geoms and joints come and go is what it was after few: live blocks and
// bytes of the C library's allocator are counted, on every thread.
//
// A program of its own, because it puts its functions in the place of the C library's.
#include <gtest/gtest.h>
#include <malloc.h>
#include <ode/ode.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <ostream>
#include <string>
#include <vector>

#include "OdeSession.h"
#include "sanitizers.h"

namespace {

struct Live {
    long blocks, bytes;
};
std::atomic<long> g_blocks{0}, g_bytes{0};

Live live() { return {g_blocks.load(), g_bytes.load()}; }

}  // namespace

#if !defined(ODE_MT_ADDRESS_SANITIZER) && !defined(ODE_MT_THREAD_SANITIZER)
static void *came(void *block) {
    if (block == nullptr) return block;
    g_blocks.fetch_add(1, std::memory_order_relaxed);
    g_bytes.fetch_add(static_cast<long>(malloc_usable_size(block)), std::memory_order_relaxed);
    return block;
}
static void goes(void *block) {
    if (block == nullptr) return;
    g_blocks.fetch_sub(1, std::memory_order_relaxed);
    g_bytes.fetch_sub(static_cast<long>(malloc_usable_size(block)), std::memory_order_relaxed);
}

extern "C" {
void *__libc_malloc(std::size_t);
void *__libc_calloc(std::size_t, std::size_t);
void *__libc_realloc(void *, std::size_t);
void *__libc_memalign(std::size_t, std::size_t);
void __libc_free(void *);

void *malloc(std::size_t size) { return came(__libc_malloc(size)); }
void *calloc(std::size_t number, std::size_t size) { return came(__libc_calloc(number, size)); }
void *realloc(void *block, std::size_t size) {
    goes(block);
    return came(__libc_realloc(block, size));
}
void *aligned_alloc(std::size_t alignment, std::size_t size) { return came(__libc_memalign(alignment, size)); }
int posix_memalign(void **block, std::size_t alignment, std::size_t size) {
    *block = came(__libc_memalign(alignment, size));
    return *block == nullptr;
}
void free(void *block) {
    goes(block);
    __libc_free(block);
}
}
#endif

namespace {

// Balls that each fall on a floor for a while and are exchanged, one a frame, for one that starts as it did, some
// hinged to their neighbour: after kBalls frames all begins again, so memory has nothing to grow for.
class ChurningWorld {
public:
    ChurningWorld(bool hash, bool quick)
        : m_world(dWorldCreate()),
          m_space(hash ? dHashSpaceCreate(nullptr) : dSimpleSpaceCreate(nullptr)),
          m_contacts(dJointGroupCreate(0)),
          m_step(quick ? dWorldQuickStep : dWorldStep) {
        dWorldSetGravity(m_world, 0, 0, dReal(-9.81));
        dCreatePlane(m_space, 0, 0, 1, 0);
        for (int i = 0; i < kBalls; ++i) make(i);
    }
    ~ChurningWorld() {
        dJointGroupDestroy(m_contacts);
        dSpaceDestroy(m_space);
        dWorldDestroy(m_world);
    }
    ChurningWorld(const ChurningWorld &) = delete;
    ChurningWorld &operator=(const ChurningWorld &) = delete;

    void frames(int count) {
        for (int frame = 0; frame < count; ++frame) {
            destroy(m_next);
            make(m_next);
            m_next = (m_next + 1) % kBalls;
            dSpaceCollide(m_space, this, &ChurningWorld::meet);
            m_step(m_world, dReal(0.01));
            dJointGroupEmpty(m_contacts);
        }
    }

private:
    static constexpr int kBalls = 8;

    void make(int i) {
        m_bodies[i] = dBodyCreate(m_world);
        dBodySetPosition(m_bodies[i], dReal(i % 4), 2 * dReal(i / 4), dReal(0.5));
        m_geoms[i] = dCreateSphere(m_space, dReal(0.5));
        dGeomSetBody(m_geoms[i], m_bodies[i]);
        m_joints[i] = nullptr;
        if (i % 4 != 1) return;
        m_joints[i] = dJointCreateHinge(m_world, nullptr);
        dJointAttach(m_joints[i], m_bodies[i], m_bodies[i - 1]);
    }
    void destroy(int i) {
        if (m_joints[i] != nullptr) dJointDestroy(m_joints[i]);
        dGeomDestroy(m_geoms[i]);
        dBodyDestroy(m_bodies[i]);
    }
    static void meet(void *self, dGeomID a, dGeomID b) {
        const ChurningWorld &churn = *static_cast<ChurningWorld *>(self);
        std::array<dContact, 4> contacts;
        const int count = dCollide(a, b, 4, &contacts[0].geom, sizeof(dContact));
        for (int i = 0; i < count; ++i) {
            contacts[i].surface.mode = 0;
            contacts[i].surface.mu = 1;
            dJointAttach(dJointCreateContact(churn.m_world, churn.m_contacts, &contacts[i]), dGeomGetBody(a),
                         dGeomGetBody(b));
        }
    }

    dWorldID m_world;
    dSpaceID m_space;
    dJointGroupID m_contacts;
    dWorldStepFunction *m_step;
    std::array<dBodyID, kBalls> m_bodies;
    std::array<dGeomID, kBalls> m_geoms;
    std::array<dJointID, kBalls> m_joints;
    int m_next = 0;
};

struct Mode {
    const char *algorithm, *policy;
    bool hash, quick;

    bool isConcurrent() const { return std::string(policy) == "concurrent"; }
};
void PrintTo(const Mode &mode, std::ostream *out) { *out << mode.algorithm << ", " << mode.policy; }

class ChurnMemory : public testing::TestWithParam<Mode> {
protected:
    void SetUp() override {
        if (kAddressSanitizer || kThreadSanitizer)
            GTEST_SKIP() << "the sanitizer has its own memory functions in the place of the C library's";
        dODE_MT_SetCallbackPolicy(GetParam().policy);
    }
    void TearDown() override {
        dODE_MT_SetCallbackPolicy("serial");
        dODE_MT_SetHeuristics("default");
    }

    // After this a cost model that is still learning, and a worker, have allocated what they need.
    void warmUp(ChurningWorld &world) const {
        OdeSession::use(threads(), "lcp");
        world.frames(200);
        OdeSession::use(threads(), GetParam().algorithm);
        world.frames(800);
    }
    int threads() const { return GetParam().isConcurrent() ? 2 : 0; }

    // Returns the memory of a worker that the system has not scheduled before: records, logs, an arena of the LCP solver, and one of the step, a
    // fifth larger than the world's, which has 64 KiB at least (dWORLDSTEP_RESERVESIZE_DEFAULT).
    Live allowed() const { return GetParam().isConcurrent() ? Live{12, 3 * 65536} : Live{0, 0}; }

    OdeSession session;
};

TEST_P(ChurnMemory, CountingWorks) {
    const Live before = live();
    void *volatile block = std::malloc(1000);
    EXPECT_EQ(live().blocks, before.blocks + 1);
    EXPECT_GE(live().bytes, before.bytes + 1000);
    std::free(block);
    EXPECT_EQ(live().blocks, before.blocks);
}

TEST_P(ChurnMemory, After10000FramesIsWhatItWasAfter1000) {
    // without those heuristics that change the grid by measured time
    dODE_MT_SetHeuristics("crossover,declustering");
    ChurningWorld world(GetParam().hash, GetParam().quick);
    warmUp(world);
    const Live before = live();
    world.frames(9000);
    EXPECT_LE(live().blocks, before.blocks + allowed().blocks);
    // The same number of bytes may come as a block that is 16 longer, where the allocator had no shorter one.
    EXPECT_LE(live().bytes, before.bytes + 16 * before.blocks + allowed().bytes);
}

// The grid may be another one by then, of up to 8000 cells, some of them with lists.
TEST_P(ChurnMemory, WithAllHeuristicsItGrowsByNoMoreThanAGrid) {
    ChurningWorld world(GetParam().hash, GetParam().quick);
    warmUp(world);
    const Live before = live();
    world.frames(9000);
    EXPECT_LE(live().blocks, before.blocks + allowed().blocks + 1000) << "less than one block in nine frames";
    EXPECT_LE(live().bytes, before.bytes + allowed().bytes + 8000 * 64 + 1000 * 64);
}

std::vector<Mode> modes() {
    std::vector<Mode> all;
    bool hash = false;
    for (const char *algorithm :
         {"auto", "serial", "lcp", "original", "static", "static-unmerged", "duplication", "decluster"})
        for (const char *policy : {"serial", "concurrent"}) {
            all.push_back({algorithm, policy, hash, !hash});
            hash = !hash;
        }
    all.push_back({"auto", "serial", true, true});
    all.push_back({"lcp", "concurrent", false, false});
    return all;
}

INSTANTIATE_TEST_SUITE_P(Modes, ChurnMemory, testing::ValuesIn(modes()), [](const auto &info) {
    const Mode &mode = info.param;
    std::string name = std::string(mode.algorithm) + "_" + mode.policy + (mode.hash ? "_hash" : "_simple");
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

}  // namespace
