// What a worker thread of the pthread manager looks like from outside.
#include <pthread.h>
#include <signal.h>

#include <set>

#include "Runs.h"
#include "threading/dxThreadManagerPthread.h"

namespace {

struct Look {
    std::string name;
    bool interruptBlocked;
    bool faultBlocked;
    std::size_t stack;
};

Look lookAtThisThread() {
    char name[16] = "";
    pthread_getname_np(pthread_self(), name, sizeof name);
    sigset_t blocked;
    pthread_sigmask(SIG_BLOCK, nullptr, &blocked);
    pthread_attr_t attributes;
    pthread_getattr_np(pthread_self(), &attributes);
    std::size_t stack = 0;
    pthread_attr_getstacksize(&attributes, &stack);
    pthread_attr_destroy(&attributes);
    return {name, sigismember(&blocked, SIGINT) == 1, sigismember(&blocked, SIGSEGV) == 1, stack};
}

TEST(WorkerThread, NameSignalsAndStack) {
    dxThreadManagerPthread manager;
    manager.resize(4);
    ASSERT_TRUE(allWorkersMeet(manager, 4)) << "all have been named";
    std::vector<Look> looks(4);
    Meeting meeting(4);
    runBlocks(manager, 4, 4, [&](unsigned, unsigned worker) {
        meeting.attend();
        looks[worker] = lookAtThisThread();
    });
    std::set<std::string> names;
    for (unsigned worker = 1; worker < 4; ++worker) {
        names.insert(looks[worker].name);
        EXPECT_TRUE(looks[worker].interruptBlocked);
        EXPECT_FALSE(looks[worker].faultBlocked) << "the host's crash handler would not be called";
        EXPECT_GE(looks[worker].stack, std::size_t{8} << 20);
    }
    EXPECT_EQ(names, (std::set<std::string>{"ode_mt-1", "ode_mt-2", "ode_mt-3"}));
    EXPECT_FALSE(looks[0].interruptBlocked) << "the caller's mask is as it was";
}

}  // namespace
