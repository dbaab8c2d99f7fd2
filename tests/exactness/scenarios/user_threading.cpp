#include "additions.h"
#include "scenario_scene.h"

#include <cstdlib>
#include <cstring>

namespace exactness {

namespace {

// Whether this library gives the bits of one thread whatever threads the user lends: ODE_MT does. On
// upstream's library the scene stays serial, for that is what it is compared with.
bool lendsWorkersSafely() { return std::getenv("ODE_MT_THREADS") != nullptr; }

// A world whose user gave it ODE's own thread pool.
class UserPool : public ManyParts {
public:
    explicit UserPool(Stepper stepper) : ManyParts(stepper) {
        addGround();
        addParts([this](int part, Vector3 origin) {
            for (int i = 0; i < 5; ++i) {
                addBox(origin + Vector3{dReal(0.02) * (part % 3), 0, dReal(0.25) + dReal(0.5) * i},
                       {0.5, 0.5, 0.5}, 1);
            }
        });
        if (lendsWorkersSafely()) lend();
    }

    ~UserPool() override {
        if (m_threading == nullptr) return;
        dThreadingImplementationShutdownProcessing(m_threading);
        dThreadingFreeThreadPool(m_pool);
        dWorldSetStepThreadingImplementation(world(), nullptr, nullptr);
        dThreadingFreeImplementation(m_threading);
    }

private:
    void lend() {
        constexpr unsigned threads = 3;
        m_threading = dThreadingAllocateMultiThreadedImplementation();
        m_pool = dThreadingAllocateThreadPool(threads, 0, dAllocateFlagBasicData, nullptr);
        dThreadingThreadPoolServeMultiThreadedImplementation(m_pool, m_threading);
        dWorldSetStepThreadingImplementation(world(), dThreadingImplementationGetFunctions(m_threading),
                                             m_threading);
        dWorldSetStepIslandsProcessingMaxThreadCount(world(), threads);
    }

    dThreadingImplementationID m_threading = nullptr;
    dThreadingThreadPoolID m_pool = nullptr;
};

// A world with an implementation of ODE's that has no threads of its own.
class SelfThreaded : public ManyParts {
public:
    explicit SelfThreaded(Stepper stepper)
        : ManyParts(stepper), m_threading(dThreadingAllocateSelfThreadedImplementation()) {
        addGround();
        addParts([this](int, Vector3 origin) {
            for (int i = 0; i < 5; ++i)
                addBox(origin + Vector3{0, 0, dReal(0.25) + dReal(0.5) * i}, {0.5, 0.5, 0.5}, 1);
        });
        dWorldSetStepThreadingImplementation(world(), dThreadingImplementationGetFunctions(m_threading),
                                             m_threading);
    }

    ~SelfThreaded() override {
        dWorldSetStepThreadingImplementation(world(), nullptr, nullptr);
        dThreadingFreeImplementation(m_threading);
    }

private:
    dThreadingImplementationID m_threading;
};

}  // namespace

void addUserThreading(Catalogue &catalogue) {
    catalogue.push_back({"user_threading/pool",
                         "a pool of three threads lent by the user, against upstream's serial step", 40,
                         make<UserPool>(), "who steps the islands is the user's affair"});
    catalogue.push_back({"user_threading/self_threaded",
                         "an implementation without threads, given by the user", 40, make<SelfThreaded>(),
                         "who steps the islands is the user's affair"});
}

}  // namespace exactness
