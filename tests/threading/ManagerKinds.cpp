#include "ManagerKinds.h"

#include <ode/odeinit.h>
#include <ode/threading_impl.h>

#include <thread>

#include "ExecutorPool.h"
#include "threading/managers/dxThreadManagerFactory.h"
#include "threading/managers/dxThreadManagerUser.h"
#include "threadSanitizer.h"

namespace {

#if defined(__clang__)
constexpr bool openMPEndsThreads = false;  // libomp cannot
#else
constexpr bool openMPEndsThreads = true;
#endif

template <int kind>
std::shared_ptr<dxThreadManager> makeByName(unsigned workers) {
    std::shared_ptr<dxThreadManager> manager =
        dxThreadManagerFactory::create(kind == 0 ? "pthread" : "openmp");
    manager->resize(workers);
    return manager;
}

// A pool of ODE's that serves an implementation.
struct OdePool {
    explicit OdePool(unsigned threads) {
        constexpr unsigned stack = 1 << 20;
        implementation = dThreadingAllocateMultiThreadedImplementation();
        pool = dThreadingAllocateThreadPool(threads, stack, dAllocateFlagBasicData, nullptr);
        dThreadingThreadPoolServeMultiThreadedImplementation(pool, implementation);
        manager = std::make_unique<dxThreadManagerUser>(dThreadingImplementationGetFunctions(implementation),
                                                        implementation);
    }
    // Destroys them in the order of a program that uses ODE: first the pool, then the world that uses it.
    ~OdePool() {
        dThreadingImplementationShutdownProcessing(implementation);
        dThreadingFreeThreadPool(pool);
        manager.reset();
        dThreadingFreeImplementation(implementation);
    }

    dThreadingImplementationID implementation;
    dThreadingThreadPoolID pool;
    std::unique_ptr<dxThreadManagerUser> manager;
};

std::shared_ptr<dxThreadManager> makeUser(unsigned workers) {
    const auto pool = std::make_shared<OdePool>(workers);
    return {pool, pool->manager.get()};
}

// An executor with a thread less than workers, for the caller is one.
struct LentPool {
    explicit LentPool(unsigned workers) : pool(workers - 1), manager(dxThreadLender{nullptr, nullptr, ExecutorPool::post, &pool}) {
        manager.resize(workers);
    }

    ExecutorPool pool;
    dxThreadManagerUser manager;
};

std::shared_ptr<dxThreadManager> makeExecutor(unsigned workers) {
    const auto pool = std::make_shared<LentPool>(workers);
    return {pool, &pool->manager};
}

std::vector<ManagerKind> managerKinds() {
    std::vector<ManagerKind> kinds;
    for (const std::string name : dxThreadManagerFactory::names()) {
        if (name == "pthread") {
            kinds.push_back({name, makeByName<0>, 1024, true, true, false, true, !underThreadSanitizer});
        } else if (name == "openmp" && !underThreadSanitizer) {
            kinds.push_back({name, makeByName<1>, 1024, true, openMPEndsThreads, true, false, true});
        }
    }
    // ODE's pool wakes all its idle threads for every call posted.
    kinds.push_back({"user", makeUser, 64, false, false, false, true, false});
    kinds.push_back({"executor", makeExecutor, 64, false, false, false, true, false});
    return kinds;
}

}  // namespace

void PrintTo(const ManagerKind &kind, std::ostream *out) { *out << kind.name; }

INSTANTIATE_TEST_SUITE_P(All, ThreadManagerTest, testing::ValuesIn(managerKinds()),
                         [](const auto &info) { return info.param.name; });

// ThreadSanitizer would end every forked child at once.
extern "C" const char *__tsan_default_options() { return "die_after_fork=0"; }

int main(int argc, char **argv) {
    testing::InitGoogleTest(&argc, argv);
    dInitODE2(0);
    std::thread([] {}).join();  // a sanitizer's own thread now runs and is not counted as new
    const int result = RUN_ALL_TESTS();
    dCloseODE();
    return result;
}
