// What a worker thread of the pthread manager looks like from outside.
//
// Covers dxProcessors.cpp, dxThreadManagerPthread.cpp.
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <set>
#include <thread>

#include "Runs.h"
#include "threading/managers/dxThreadManagerPthread.h"
#include "threading/process/dxProcessors.h"

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

// What a thread is bound to: processors, scheduling, niceness.
struct Bounds {
    cpu_set_t processors;
    int policy;
    int niceness;
};

Bounds boundsOfThisThread() {
    Bounds bounds{};
    CPU_ZERO(&bounds.processors);
    sched_getaffinity(0, sizeof bounds.processors, &bounds.processors);
    bounds.policy = sched_getscheduler(0);
    bounds.niceness = getpriority(PRIO_PROCESS, 0);
    return bounds;
}

// The bounds of a worker that a thread starts which `bind` has been called on.
template <class Bind>
Bounds boundsOfAWorker(const Bind &bind) {
    Bounds bounds{};
    std::thread([&] {
        bind();
        dxThreadManagerPthread manager;
        manager.resize(2);
        Meeting meeting(2);
        runBlocks(manager, 2, 2, [&](unsigned, unsigned worker) {
            meeting.attend();
            if (worker == 1) bounds = boundsOfThisThread();
        });
    }).join();
    return bounds;
}

void bindToOneProcessor() {
    const Bounds own = boundsOfThisThread();
    int processor = 0;
    while (!CPU_ISSET(processor, &own.processors)) ++processor;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(processor, &one);
    ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
}

TEST(WorkerThread, HasTheProcessorsOfTheProcess) {
    const Bounds here = boundsOfThisThread();
    if (CPU_COUNT(&here.processors) < 2) GTEST_SKIP() << "one processor";
    const Bounds worker = boundsOfAWorker(bindToOneProcessor);
    EXPECT_TRUE(CPU_EQUAL(&worker.processors, &here.processors));
}

// This holds also if the first thread of the process has changed its affinity.
TEST(WorkerThread, HasTheProcessorsThatTheProcessBeganWith) {
    const Bounds here = boundsOfThisThread();
    if (CPU_COUNT(&here.processors) < 2) GTEST_SKIP() << "one processor";
    bindToOneProcessor();
    const Bounds worker = boundsOfAWorker([] {});
    EXPECT_EQ(dxCountProcessors(), static_cast<unsigned>(CPU_COUNT(&here.processors)));
    ASSERT_EQ(sched_setaffinity(0, sizeof here.processors, &here.processors), 0);
    EXPECT_TRUE(CPU_EQUAL(&worker.processors, &here.processors));
}

TEST(WorkerThread, HasOrdinaryScheduling) {
    bool allowed = false;
    const Bounds worker = boundsOfAWorker([&allowed] {
        sched_param priority{};
        priority.sched_priority = 1;
        allowed = sched_setscheduler(0, SCHED_FIFO, &priority) == 0;
        if (!allowed) allowed = sched_setscheduler(0, SCHED_BATCH, &(priority = {})) == 0;
    });
    if (!allowed) GTEST_SKIP() << "the system allows no other scheduling";
    EXPECT_EQ(worker.policy, SCHED_OTHER);
}

TEST(WorkerThread, IsAsNiceAsTheProcess) {
    const int niceness = getpriority(PRIO_PROCESS, 0);
    bool allowed = false;  // to be less nice again
    const Bounds worker = boundsOfAWorker([&] {
        allowed = setpriority(PRIO_PROCESS, 0, niceness + 1) == 0 && setpriority(PRIO_PROCESS, 0, niceness) == 0;
        setpriority(PRIO_PROCESS, 0, niceness + 1);
    });
    if (!allowed) GTEST_SKIP() << "the system does not let a thread be less nice";
    EXPECT_EQ(worker.niceness, niceness);
}

int refuseBounds(pthread_t *thread, const pthread_attr_t *attributes, void *(*body)(void *), void *context) {
    int inherits = 0;
    pthread_attr_getinheritsched(attributes, &inherits);
    return inherits == PTHREAD_EXPLICIT_SCHED ? EPERM : pthread_create(thread, attributes, body, context);
}

TEST(WorkerThread, StartsAlsoWhereTheSystemRefusesItsBounds) {
    dxThreadManagerPthread manager(refuseBounds);
    manager.resize(3);
    EXPECT_TRUE(allWorkersMeet(manager, 3));
}

}  // namespace
