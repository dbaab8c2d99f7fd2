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

// The same, through functions of the program's that count calls, refuse some and throw.
class Watched : public ManyParts {
public:
    explicit Watched(Stepper stepper) : ManyParts(stepper) {
        addGround();
        addParts([this](int, Vector3 origin) {
            for (int i = 0; i < 5; ++i) addBox(origin + Vector3{0, 0, dReal(0.25) + dReal(0.5) * i}, {0.5, 0.5, 0.5}, 1);
        });
        m_functions.post_call = &post;
        m_functions.alter_call_dependencies_count = &alter;
        m_functions.wait_call = &wait;
        m_functions.preallocate_resources_for_calls = &preallocate;
        dWorldSetStepThreadingImplementation(world(), &m_functions, m_threading);
    }

    ~Watched() override {
        dWorldSetStepThreadingImplementation(world(), nullptr, nullptr);
        dThreadingFreeImplementation(m_threading);
    }

protected:
    void stepWorld(dWorldID world) override {
        try {
            note("stepped", stepper() == Stepper::Quick ? dWorldQuickStep(world, stepLength) : dWorldStep(world, stepLength));
        } catch (const Left &) {
            note("left");
        }
        note("calls", m_posted);
        note("changes", m_altered);
        note("waits", m_waited);
        note("preparations", m_prepared);
    }

private:
    struct Left {};

    static Watched &self() { return static_cast<Watched &>(living()); }

    static void post(dThreadingImplementationID impl, int *fault, dCallReleaseeID *releasee, ddependencycount_t dependencies,
                     dCallReleaseeID dependent, dCallWaitID waits, dThreadedCallFunction *call, void *context,
                     dcallindex_t index, const char *name) {
        ++self().m_posted;
        self().m_upstream->post_call(impl, fault, releasee, dependencies, dependent, waits, call, context, index, name);
        if (self().frameNumber() % 7 == 3 && fault != nullptr) *fault = 1;
    }
    static void alter(dThreadingImplementationID impl, dCallReleaseeID releasee, ddependencychange_t change) {
        ++self().m_altered;
        self().m_upstream->alter_call_dependencies_count(impl, releasee, change);
    }
    static void wait(dThreadingImplementationID impl, int *status, dCallWaitID waits, const dThreadedWaitTime *limit,
                     const char *name) {
        ++self().m_waited;
        self().m_upstream->wait_call(impl, status, waits, limit, name);
        if (self().frameNumber() % 7 == 4) throw Left();
    }
    static int preallocate(dThreadingImplementationID impl, ddependencycount_t calls) {
        self().m_prepared += calls;
        return self().frameNumber() % 7 == 5 ? 0 : self().m_upstream->preallocate_resources_for_calls(impl, calls);
    }

    dThreadingImplementationID m_threading = dThreadingAllocateSelfThreadedImplementation();
    const dThreadingFunctionsInfo *m_upstream = dThreadingImplementationGetFunctions(m_threading);
    dThreadingFunctionsInfo m_functions = *m_upstream;
    double m_posted = 0, m_altered = 0, m_waited = 0, m_prepared = 0;
};

}  // namespace

void addUserThreading(Catalogue &catalogue) {
    catalogue.push_back({"user_threading/pool",
                         "a pool of three threads lent by the user, against upstream's serial step", 40,
                         make<UserPool>(), "the user's implementation steps the islands"});
    catalogue.push_back({"user_threading/self_threaded",
                         "an implementation without threads, given by the user", 40, make<SelfThreaded>(),
                         "the user's implementation steps the islands"});
    catalogue.push_back({"user_threading/watched", "the same, through functions that count calls, refuse some and throw", 40,
                         make<Watched>(), "the user's implementation steps the islands"});
}

}  // namespace exactness
