// dlclose of libode.so.8 after parallel steps: no crash, no thread left, nothing that keeps the library.
//
// Covers api/odeinit.cpp.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <malloc.h>
#include <ode/ode.h>

#include <atomic>
#include <chrono>
#include <cstring>
#include <fstream>
#include <string>
#include <thread>

#include "processThreads.h"
#include "sanitizers.h"

#ifdef ODE_MT_ADDRESS_SANITIZER
#include <sanitizer/lsan_interface.h>
#endif

namespace {

// The shared library under test, unloaded by the destructor.
//
// Upstream does not free what it keeps for the length of the process when it is unloaded.
class LoadedOde {
public:
    explicit LoadedOde(const char *library = ODE_MT_LIBRARY) {
        forgetLeaks(true);
        m_handle = dlopen(library, RTLD_NOW | RTLD_LOCAL);
        if (m_handle == nullptr) ADD_FAILURE() << dlerror();
    }
    ~LoadedOde() {
        EXPECT_EQ(dlclose(m_handle), 0);
        forgetLeaks(false);
    }
    LoadedOde(const LoadedOde &) = delete;
    LoadedOde &operator=(const LoadedOde &) = delete;

    template <class Function>
    Function *get(Function *, const char *name) const {
        return reinterpret_cast<Function *>(dlsym(m_handle, name));
    }

    // For the calling thread.
    static void forgetLeaks([[maybe_unused]] bool on) {
#ifdef ODE_MT_ADDRESS_SANITIZER
        on ? __lsan_disable() : __lsan_enable();
#endif
    }

private:
    void *m_handle = nullptr;
};

#define ODE_FUNCTION(library, name) (library).get(name, #name)

bool inMemory() {
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);) {
        if (line.find(ODE_MT_LIBRARY) != std::string::npos) return true;
    }
    return false;
}

// Unconnected bodies are islands of one body each.
void step(const LoadedOde &ode) {
    const dWorldID world = ODE_FUNCTION(ode, dWorldCreate)();
    for (int i = 0; i < 500; ++i) ODE_FUNCTION(ode, dBodyCreate)(world);
    for (int i = 0; i < 5; ++i) ODE_FUNCTION(ode, dWorldQuickStep)(world, 0.01);
    ODE_FUNCTION(ode, dWorldDestroy)(world);
}

void stepInParallel(const LoadedOde &ode, const char *manager, const char *algorithm = "lcp") {
    ODE_FUNCTION(ode, dInitODE2)(0);
    ODE_FUNCTION(ode, dODE_MT_SetThreadManager)(manager);
    ODE_FUNCTION(ode, dToggleODE_MT)(4);
    ODE_FUNCTION(ode, dODE_MT_SetAlgorithm)(algorithm);
    step(ode);
    EXPECT_EQ(ODE_FUNCTION(ode, dODE_MT_GetParallelSteps)(), std::strcmp(algorithm, "serial") == 0 ? 0u : 5u);
}

// An own scratch allocation of this thread, freed at its end or at the unloading.
void collideMeshes(const LoadedOde &ode) {
    static const float vertices[] = {-1, -1, 0, 1, -1, 0, 0, 1, 0};
    static const dTriIndex indices[] = {0, 1, 2};
    const dTriMeshDataID data = ODE_FUNCTION(ode, dGeomTriMeshDataCreate)();
    ODE_FUNCTION(ode, dGeomTriMeshDataBuildSingle)
    (data, vertices, 3 * sizeof(float), 3, indices, 3, 3 * sizeof(dTriIndex));
    const dGeomID mesh = ODE_FUNCTION(ode, dCreateTriMesh)(nullptr, data, nullptr, nullptr, nullptr);
    const dGeomID ball = ODE_FUNCTION(ode, dCreateSphere)(nullptr, 0.5);
    dContactGeom contacts[4];
    EXPECT_GT(ODE_FUNCTION(ode, dCollide)(mesh, ball, 4, contacts, sizeof contacts[0]), 0);
    ODE_FUNCTION(ode, dGeomDestroy)(ball);
    ODE_FUNCTION(ode, dGeomDestroy)(mesh);
    ODE_FUNCTION(ode, dGeomTriMeshDataDestroy)(data);
}

class Unload : public testing::TestWithParam<bool> {};

TEST_P(Unload, LeavesNothingBehind) {
    const unsigned before = processThreads();
    for (int i = 0; i < 5; ++i) {
        {
            const LoadedOde ode;
            EXPECT_TRUE(inMemory());
            stepInParallel(ode, "pthread");
            EXPECT_GT(processThreads(), before);
            collideMeshes(ode);
            if (GetParam()) ODE_FUNCTION(ode, dCloseODE)();
        }
        EXPECT_TRUE(threadsFallTo(before));
        EXPECT_FALSE(inMemory());
    }
}

// The OpenMP runtime is a library of its own and may stay, with the threads of its first use; ours goes.
TEST_P(Unload, WithOpenMP) {
    skipIfUnseen("openmp");
    if (IsSkipped()) return;
    const auto use = [] {
        const LoadedOde ode;
        stepInParallel(ode, "openmp");
        if (GetParam()) ODE_FUNCTION(ode, dCloseODE)();
    };
    use();
    const unsigned before = processThreads();
    use();
    EXPECT_TRUE(threadsFallTo(before));
    EXPECT_FALSE(inMemory());
}

INSTANTIATE_TEST_SUITE_P(Close, Unload, testing::Bool(),
                         [](const auto &info) { return info.param ? "closed" : "notClosed"; });

// A thread that has called the library ends a while after it has gone.
template <class Use>
void outliveTheLibrary(Use use, std::chrono::milliseconds longer) {
    std::atomic<bool> used{false}, gone{false};
    std::thread user;
    {
        const LoadedOde ode;
        ODE_FUNCTION(ode, dInitODE2)(0);
        user = std::thread([&] {
            LoadedOde::forgetLeaks(true);
            use(ode);
            LoadedOde::forgetLeaks(false);
            used = true;
            while (!gone) std::this_thread::yield();
        });
        while (!used) std::this_thread::yield();
        ODE_FUNCTION(ode, dCloseODE)();
    }
    EXPECT_FALSE(inMemory());
    std::this_thread::sleep_for(longer);
    gone = true;
    user.join();
}

TEST(UnloadThreads, ThreadOutlivesTheLibrary) { outliveTheLibrary(collideMeshes, std::chrono::milliseconds(0)); }

// The pool of such a thread sleeps in the OpenMP runtime, which must not go before it.
TEST(UnloadThreads, ThreadWithAnOpenMPPoolOutlivesTheLibrary) {
    skipIfUnseen("openmp");
    if (IsSkipped()) return;
    constexpr std::chrono::milliseconds kUntilIdleThreadsSleep{20};
    for (int i = 0; i < 5; ++i)
        outliveTheLibrary([](const LoadedOde &ode) { stepInParallel(ode, "openmp"); }, kUntilIdleThreadsSleep);
}

// Bytes in use that coming, stepping and going leave behind.
double lostEachTime(const char *library, const char *algorithm, const char *manager) {
    constexpr int kWarm = 10, kTimes = 100;
    std::size_t before = 0;
    for (int i = 0; i < kWarm + kTimes; ++i) {
        if (i == kWarm) before = mallinfo2().uordblks;
        const LoadedOde ode(library);
        if (algorithm != nullptr) {
            stepInParallel(ode, manager, algorithm);
        } else {
            ODE_FUNCTION(ode, dInitODE2)(0);
            step(ode);
        }
        collideMeshes(ode);
        ODE_FUNCTION(ode, dCloseODE)();
    }
    return (static_cast<double>(mallinfo2().uordblks) - static_cast<double>(before)) / kTimes;
}

// What stays lies between what is freed, so that the C library can give nothing back: it costs many times its size.
TEST(UnloadMemory, NoMoreIsLostThanWithUpstream) {
    const double upstream = lostEachTime(ODE_MT_DEBIAN_ODE, nullptr, nullptr);
    for (const char *algorithm : {"serial", "lcp", "decluster"})
        for (const char *manager : {"pthread", "openmp"})
            EXPECT_LT(lostEachTime(ODE_MT_LIBRARY, algorithm, manager), upstream + 250) << algorithm << ' ' << manager;
}

TEST(UnloadUnused, NothingWasCalled) {
    for (int i = 0; i < 3; ++i) {
        { const LoadedOde ode; }
        EXPECT_FALSE(inMemory());
    }
}

}  // namespace
