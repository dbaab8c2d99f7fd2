// Workers start as the options say, and options that the system refuses are recognised before they are taken.
#include "threading/pool/dxWorkerThread.h"

#include <sys/resource.h>
#include <unistd.h>

#include <cstring>
#include <string>
#include <vector>

#include "Runs.h"
#include "threading/managers/dxThreadManagerPthread.h"

namespace {

struct Look {
    std::string name;
    std::size_t stack = 0;
    cpu_set_t processors{};
    int policy = -1;
    int niceness = 0;

    static Look atThisThread() {
        Look look;
        char text[16] = "";
        pthread_getname_np(pthread_self(), text, sizeof text);
        look.name = text;
        pthread_attr_t attributes;
        pthread_getattr_np(pthread_self(), &attributes);
        pthread_attr_getstacksize(&attributes, &look.stack);
        pthread_attr_destroy(&attributes);
        sched_getaffinity(0, sizeof look.processors, &look.processors);
        look.policy = sched_getscheduler(0);
        look.niceness = getpriority(PRIO_PROCESS, 0);
        return look;
    }
};

// What the only worker of a manager with these options is like.
Look workerWith(const dxWorkerOptions &options) {
    dxThreadManagerPthread manager(pthread_create, options);
    manager.resize(2);
    Meeting meeting(2);
    Look look;
    runBlocks(manager, 2, 2, [&](unsigned, unsigned worker) {
        meeting.attend();
        if (worker == 1) look = Look::atThisThread();
    });
    EXPECT_TRUE(meeting.complete());
    return look;
}

cpu_set_t setOf(int processor) {
    cpu_set_t set;
    CPU_ZERO(&set);
    CPU_SET(processor, &set);
    return set;
}

TEST(WorkerOptions, NameAndStack) {
    dxWorkerOptions options;
    EXPECT_TRUE(options.areDefault());
    std::strcpy(options.name, "abcdefghij");
    options.stack = std::size_t{256} << 10;
    EXPECT_FALSE(options.areDefault());
    EXPECT_EQ(dxTryWorker(options), 0);
    const Look look = workerWith(options);
    EXPECT_EQ(look.name, "abcdefghij-1");
    EXPECT_GE(look.stack, options.stack);  // a sanitizer takes some of it
    EXPECT_LT(look.stack, dxWorkerOptions::kDefaultStack);
}

TEST(WorkerOptions, NamesAreNumbered) {
    dxThreadManagerPthread manager;
    for (int i = 0; i < 2; ++i) {  // anew after an end
        manager.resize(3);
        std::vector<std::string> names(3);
        Meeting meeting(3);
        runBlocks(manager, 3, 3, [&](unsigned, unsigned worker) {
            meeting.attend();
            names[worker] = Look::atThisThread().name;
        });
        EXPECT_EQ(std::min(names[1], names[2]), "ode_mt-1");
        EXPECT_EQ(std::max(names[1], names[2]), "ode_mt-2");
        manager.stop();
    }
}

TEST(WorkerOptions, Processors) {
    cpu_set_t here;
    sched_getaffinity(0, sizeof here, &here);
    int last = CPU_SETSIZE - 1;
    while (!CPU_ISSET(last, &here)) --last;
    dxWorkerOptions options;
    options.processors = setOf(last);
    EXPECT_EQ(dxTryWorker(options), 0);
    const Look look = workerWith(options);
    EXPECT_TRUE(CPU_EQUAL(&look.processors, &*options.processors));
}

TEST(WorkerOptions, Scheduling) {
    dxWorkerOptions options;
    options.scheduling = dxWorkerScheduling::find("batch", std::min(getpriority(PRIO_PROCESS, 0) + 1, 19));
    ASSERT_TRUE(options.scheduling);
    EXPECT_EQ(dxTryWorker(options), 0);
    const Look batch = workerWith(options);
    EXPECT_EQ(batch.policy, SCHED_BATCH);
    EXPECT_EQ(batch.niceness, options.scheduling->priority);
    options.scheduling = dxWorkerScheduling::find("idle", 0);
    EXPECT_EQ(workerWith(options).policy, SCHED_IDLE);
}

// Real-time scheduling needs a privilege, and the answer is the system's.
TEST(WorkerOptions, RealTimeWhereTheSystemAllowsIt) {
    dxWorkerOptions options;
    options.scheduling = dxWorkerScheduling::find("fifo", 1);
    if (dxTryWorker(options) == 0) {
        EXPECT_EQ(workerWith(options).policy, SCHED_FIFO);
    } else {
        testing::internal::CaptureStderr();
        EXPECT_EQ(workerWith(options).policy, SCHED_OTHER);
        EXPECT_NE(testing::internal::GetCapturedStderr().find("ode_mt-1 has ordinary scheduling"), std::string::npos);
    }
}

TEST(WorkerOptions, NamesOfSchedulings) {
    EXPECT_EQ(dxWorkerScheduling::find("normal", -20)->policy, SCHED_OTHER);
    EXPECT_EQ(dxWorkerScheduling::find("round-robin", 99)->policy, SCHED_RR);
    EXPECT_FALSE(dxWorkerScheduling::find("normal", 20));
    EXPECT_FALSE(dxWorkerScheduling::find("normal", -21));
    EXPECT_FALSE(dxWorkerScheduling::find("idle", 1));
    EXPECT_FALSE(dxWorkerScheduling::find("fifo", 0));
    EXPECT_FALSE(dxWorkerScheduling::find("round-robin", 100));
    EXPECT_FALSE(dxWorkerScheduling::find("deadline", 1));
}

TEST(WorkerOptions, WhatTheSystemRefuses) {
    dxWorkerOptions options;
    const long last = sysconf(_SC_NPROCESSORS_CONF);
    ASSERT_LT(last, CPU_SETSIZE);
    options.processors = setOf(CPU_SETSIZE - 1);
    EXPECT_EQ(dxTryWorker(options), EINVAL);
    options.processors.reset();
    options.stack = std::size_t{1} << 60;
    EXPECT_NE(dxTryWorker(options), 0);
    options.stack = 0;
    EXPECT_EQ(dxTryWorker(options), 0);
    const auto refuse = [](pthread_t *, const pthread_attr_t *, void *(*)(void *), void *) { return EAGAIN; };
    EXPECT_EQ(dxTryWorker(options, refuse), EAGAIN);
}

}  // namespace
