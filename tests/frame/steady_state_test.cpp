// Steps and frames of a world that does not change take no memory from the system: every thread's calls of malloc and
// its relatives during the steps are counted.
//
// A program of its own, because it puts its functions in the place of the C library's.
//
// Covers dxJointRemoval.cpp, dxStepRecords.cpp, dxWorkingMemory.cpp.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <string>
#include <vector>

#include "ChainWorld.h"
#include "HeapWorld.h"
#include "OdeSession.h"
#include "sanitizers.h"

namespace {

std::atomic<bool> g_counting{false};
std::atomic<unsigned> g_allocations{0};

}  // namespace

#if !defined(ODE_MT_ADDRESS_SANITIZER) && !defined(ODE_MT_THREAD_SANITIZER)
static void count() {
    if (g_counting.load(std::memory_order_relaxed)) g_allocations.fetch_add(1, std::memory_order_relaxed);
}

extern "C" {
void *__libc_malloc(std::size_t);
void *__libc_calloc(std::size_t, std::size_t);
void *__libc_realloc(void *, std::size_t);
void *__libc_memalign(std::size_t, std::size_t);

void *malloc(std::size_t size) {
    count();
    return __libc_malloc(size);
}
void *calloc(std::size_t number, std::size_t size) {
    count();
    return __libc_calloc(number, size);
}
void *realloc(void *block, std::size_t size) {
    count();
    return __libc_realloc(block, size);
}
void *aligned_alloc(std::size_t alignment, std::size_t size) {
    count();
    return __libc_memalign(alignment, size);
}
int posix_memalign(void **block, std::size_t alignment, std::size_t size) {
    count();
    *block = __libc_memalign(alignment, size);
    return *block == nullptr;
}
}
#endif

namespace {

struct Mode {
    int threads;
    const char *algorithm, *manager;
    dWorldStepFunction *stepper;
    const char *solver = "exact";
};

void PrintTo(const Mode &mode, std::ostream *out) {
    *out << mode.threads << " threads, " << mode.algorithm << ", " << mode.manager;
}

class SteadyState : public testing::TestWithParam<Mode> {
protected:
    void SetUp() override {
        if (kAddressSanitizer || kThreadSanitizer) {
            GTEST_SKIP() << "the sanitizer has its own memory functions in the place of the C library's";
        }
        dODE_MT_SetThreadManager(GetParam().manager);
    }

    static void chooseSolver(dWorldID world) { dODE_MT_SetSolver(world, GetParam().solver); }
    void TearDown() override { dODE_MT_SetThreadManager("pthread"); }

    template <class Function>
    static unsigned allocationsOf(Function function) {
        g_allocations = 0;
        g_counting = true;
        function();
        g_counting = false;
        return g_allocations;
    }

    static constexpr unsigned kSteps = 300;

    // After this a cost model that is still learning has had its first parallel step.
    template <class Frame>
    static void warmUp(Frame frame) {
        OdeSession::use(GetParam().threads, "lcp");
        for (int i = 0; i < 100; ++i) frame();
        OdeSession::use(GetParam().threads, GetParam().algorithm);
        for (int i = 0; i < 10; ++i) frame();
    }

    // Returns the allocations of all steps: a worker that the system has not scheduled before allocates its memory when it first
    // does, the arena of the step and that of the LCP solver, each with its administration.
    static unsigned allowed() {
        constexpr unsigned kPerWorker = 4;
        return kPerWorker * static_cast<unsigned>(std::max(GetParam().threads - 1, 0));
    }

    OdeSession session;
};

TEST_P(SteadyState, CountingWorks) {
    void *volatile block = nullptr;
    EXPECT_EQ(allocationsOf([&] { block = std::malloc(10); }), 1u);
    std::free(block);
    std::vector<int> *volatile vector = nullptr;
    EXPECT_GE(allocationsOf([&] { vector = new std::vector<int>(5); }), 2u);
    delete vector;
}

TEST_P(SteadyState, StepsAllocateNothing) {
    ChainWorld world(40, 4, GetParam().stepper);
    chooseSolver(world.world());
    warmUp([&] { world.step(); });
    EXPECT_LE(allocationsOf([&] { world.step(kSteps); }), allowed());
}

// Contact joints come and go between the steps.
TEST_P(SteadyState, StepsWithContactsAllocateNothing) {
    ChainWorld world(40, 4, GetParam().stepper);
    chooseSolver(world.world());
    const dJointGroupID contacts = dJointGroupCreate(0);
    const auto frame = [&] {
        for (std::size_t i = 0; i < world.bodies().size(); i += 2) {
            dContact contact{};
            contact.surface.mu = 0.5;
            contact.geom.normal[2] = 1;
            const dReal *position = dBodyGetPosition(world.bodies()[i]);
            std::copy(position, position + 3, contact.geom.pos);
            dJointAttach(dJointCreateContact(world.world(), contacts, &contact), world.bodies()[i], nullptr);
        }
        const unsigned allocations = allocationsOf([&] { world.step(); });
        dJointGroupEmpty(contacts);
        return allocations;
    };
    warmUp(frame);
    unsigned allocations = 0;
    for (unsigned i = 0; i < kSteps; ++i) allocations += frame();
    EXPECT_LE(allocations, allowed());
    dJointGroupDestroy(contacts);
}

dSpaceID createQuadTree(dSpaceID parent) {
    const dVector3 centre = {0, 0, 0}, extents = {10, 10, 10};
    return dQuadTreeSpaceCreate(parent, centre, extents, 3);
}

// Whole frames: pairs, contacts, contact joints, step. A worker that is scheduled late allocates for both parts of a frame, a dozen times; what
// allocated in each frame would do so forty times.
TEST_P(SteadyState, FramesOfAHeapAllocateNothing) {
    for (const auto create : {dSimpleSpaceCreate, dHashSpaceCreate, createQuadTree, createSweepSpace}) {
        HeapWorld world(create(nullptr));
        chooseSolver(world.world());
        const auto frame = [&] {
            world.collide();
            world.step();
        };
        warmUp(frame);
        constexpr unsigned kFrames = 40;
        const unsigned allocations = allocationsOf([&] {
            for (unsigned i = 0; i < kFrames; ++i) frame();
        });
        EXPECT_LE(allocations, allowed() == 0 ? 0 : kFrames / 2);
    }
}

std::vector<Mode> modes() {
    std::vector<Mode> all;
    for (dWorldStepFunction *stepper : {dWorldStep, dWorldQuickStep}) {
        for (const int threads : {0, 2, 5}) {
            all.push_back({threads, "lcp", "pthread", stepper});
            all.push_back({threads, "lcp", "openmp", stepper});
        }
        all.push_back({4, "auto", "pthread", stepper});
    }
    for (const int threads : {0, 3}) all.push_back({threads, "lcp", "pthread", dWorldQuickStep, "fast"});
    return all;
}

INSTANTIATE_TEST_SUITE_P(Modes, SteadyState, testing::ValuesIn(modes()), [](const auto &info) {
    const Mode &mode = info.param;
    return std::string(mode.solver) + (mode.stepper == dWorldStep ? "_world_" : "_quick_") + mode.manager + "_" +
           mode.algorithm + std::to_string(mode.threads);
});

}  // namespace
