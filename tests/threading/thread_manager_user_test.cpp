// What is special about threads that the program lends by a threading implementation.
#include <ode/odeinit.h>
#include <ode/threading_impl.h>

#include <deque>
#include <memory>
#include <mutex>
#include <thread>

#include "Runs.h"
#include "threading/managers/dxThreadManagerUser.h"

namespace {

// A user's own implementation: calls are kept until the test runs them.
class KeptCalls {
public:
    explicit KeptCalls(unsigned threads) : threadCount(threads) {
        functions.struct_size = sizeof functions;
        functions.post_call = post;
        functions.retrieve_thread_count = [](dThreadingImplementationID impl) {
            return self(impl)->threadCount;
        };
        functions.preallocate_resources_for_calls = [](dThreadingImplementationID, ddependencycount_t) {
            return 1;
        };
    }

    dThreadingImplementationID id() { return reinterpret_cast<dThreadingImplementationID>(this); }

    std::size_t waiting() {
        const std::lock_guard<std::mutex> hold(lock);
        return calls.size();
    }

    bool runOne() {
        Call call;
        {
            const std::lock_guard<std::mutex> hold(lock);
            if (calls.empty()) return false;
            call = calls.front();
            calls.pop_front();
        }
        call.function(call.context, call.index, nullptr);
        return true;
    }

    dThreadingFunctionsInfo functions{};

private:
    struct Call {
        dThreadedCallFunction *function;
        void *context;
        dcallindex_t index;
    };

    static KeptCalls *self(dThreadingImplementationID id) { return reinterpret_cast<KeptCalls *>(id); }

    static void post(dThreadingImplementationID id, int *, dCallReleaseeID *, ddependencycount_t,
                     dCallReleaseeID, dCallWaitID, dThreadedCallFunction *function, void *context,
                     dcallindex_t index, const char *) {
        const std::lock_guard<std::mutex> hold(self(id)->lock);
        self(id)->calls.push_back({function, context, index});
    }

    const unsigned threadCount;
    std::mutex lock;
    std::deque<Call> calls;
};

TEST(UserThreads, PoolThatDoesNotServeYet) {
    KeptCalls pool(4);
    dxThreadManagerUser manager(&pool.functions, pool.id());
    for (int i = 0; i < 100; ++i) EXPECT_TRUE(everyBlockOnce(manager, 50, 4));
    EXPECT_EQ(pool.waiting(), 1u) << "calls pile up";
    EXPECT_FALSE(manager.idle());
    EXPECT_TRUE(pool.runOne());
    EXPECT_EQ(pool.waiting(), 0u) << "a late call finds nothing to do";
    EXPECT_TRUE(manager.idle());
}

TEST(UserThreads, CallTakenUpAfterTheManagerIsGone) {
    KeptCalls pool(4);
    testing::internal::CaptureStderr();
    {
        dxThreadManagerUser manager(&pool.functions, pool.id());
        EXPECT_TRUE(everyBlockOnce(manager, 50, 4));
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "upstream says nothing";
    EXPECT_TRUE(pool.runOne());
}

// An implementation may run a call at once, on the thread that posts it.
TEST(UserThreads, ImplementationThatRunsCallsAtOnce) {
    KeptCalls pool(4);
    pool.functions.post_call = [](dThreadingImplementationID, int *, dCallReleaseeID *, ddependencycount_t,
                                  dCallReleaseeID, dCallWaitID, dThreadedCallFunction *function,
                                  void *context, dcallindex_t index,
                                  const char *) { function(context, index, nullptr); };
    dxThreadManagerUser manager(&pool.functions, pool.id());
    EXPECT_TRUE(everyBlockOnce(manager, 50, 4));
    EXPECT_TRUE(manager.idle());
}

TEST(UserThreads, SelfThreadedImplementationLendsNobody) {
    const dThreadingImplementationID implementation = dThreadingAllocateSelfThreadedImplementation();
    {
        dxThreadManagerUser manager(dThreadingImplementationGetFunctions(implementation), implementation);
        EXPECT_EQ(manager.workers(), 1u);
        EXPECT_TRUE(everyBlockOnce(manager, 50, 4));
    }
    dThreadingFreeImplementation(implementation);
}

// ODE's pool aborts if it is shut down with two calls waiting, so this must hold after any run.
TEST(UserThreads, PoolCanBeShutDownRightAfterARun) {
    for (int i = 0; i < 200; ++i) {
        const dThreadingImplementationID implementation = dThreadingAllocateMultiThreadedImplementation();
        const dThreadingThreadPoolID pool =
            dThreadingAllocateThreadPool(3, 0, dAllocateFlagBasicData, nullptr);
        dThreadingThreadPoolServeMultiThreadedImplementation(pool, implementation);
        {
            dxThreadManagerUser manager(dThreadingImplementationGetFunctions(implementation), implementation);
            EXPECT_TRUE(everyBlockOnce(manager, 4, 3));
            dThreadingImplementationShutdownProcessing(implementation);
            dThreadingFreeThreadPool(pool);
        }
        dThreadingFreeImplementation(implementation);
    }
}

}  // namespace
