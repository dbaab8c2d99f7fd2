// How workers are to start, as programs ask for it: what is valid, what is refused and how, and that hooks may call what they are allowed to.
//
// Covers api/ode_MT_workers.cpp.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <dirent.h>

#include <atomic>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "ChainWorld.h"
#include "support/child_run.h"
#include "OdeSession.h"
#include "processThreads.h"
#include "sanitizers.h"

namespace {

int threadsNamed(const std::string &prefix) {
    int count = 0;
    DIR *tasks = opendir("/proc/self/task");
    while (const dirent *entry = readdir(tasks)) {
        std::ifstream file(std::string("/proc/self/task/") + entry->d_name + "/comm");
        std::string name;
        count += std::getline(file, name) && name.rfind(prefix, 0) == 0;
    }
    closedir(tasks);
    return count;
}

// Steps until a worker has joined.
void useWorkers(ChainWorld &world) {
    ASSERT_TRUE(waitUntil(
        [&world] {
            world.step();
            return processThreads() >= 3;
        },
        30));
}

class Workers : public testing::Test {
protected:
    void TearDown() override {
        dODE_MT_SetWorkerName(nullptr);
        dODE_MT_SetWorkerAffinity(nullptr, 0);
        dODE_MT_SetWorkerPriority(nullptr, 0);
        dODE_MT_SetWorkerStackSize(0);
        dODE_MT_SetWorkerHooks(nullptr, nullptr, nullptr);
    }

    // What is written to stderr by a call that returns 0.
    template <class Call>
    static std::string refusal(const Call &call) {
        testing::internal::CaptureStderr();
        const int done = call();
        const std::string text = testing::internal::GetCapturedStderr();
        EXPECT_EQ(done, 0) << text;
        return text;
    }

    const OdeSession session{3, "lcp"};
    ChainWorld world{40, 4};
};

TEST_F(Workers, HaveTheNameThatIsSet) {
    EXPECT_EQ(dODE_MT_SetWorkerName("physics"), 1);
    useWorkers(world);
    EXPECT_GE(threadsNamed("physics-"), 1);
    EXPECT_EQ(threadsNamed("ode_mt-"), 0);
    EXPECT_EQ(dODE_MT_SetWorkerName(nullptr), 1);
    EXPECT_EQ(threadsNamed("physics-"), 0) << "they have ended";
    useWorkers(world);
    EXPECT_GE(threadsNamed("ode_mt-"), 1);
}

TEST_F(Workers, OptionsThatAreNone) {
    EXPECT_NE(refusal([] { return dODE_MT_SetWorkerName(""); }).find("no worker name ''"), std::string::npos);
    EXPECT_NE(refusal([] { return dODE_MT_SetWorkerName("elevenchars"); }).find("1 to 10 characters"), std::string::npos);
    const int beyond[] = {0, 100000}, below[] = {-1};
    EXPECT_NE(refusal([&] { return dODE_MT_SetWorkerAffinity(beyond, 2); }).find("no processor 100000"), std::string::npos);
    EXPECT_NE(refusal([&] { return dODE_MT_SetWorkerAffinity(below, 1); }).find("no processor -1"), std::string::npos);
    EXPECT_NE(refusal([] { return dODE_MT_SetWorkerAffinity(nullptr, 1); }).find("(NULL)"), std::string::npos);
    EXPECT_NE(refusal([&] { return dODE_MT_SetWorkerAffinity(beyond, -1); }).find("no list of -1 processors"), std::string::npos);
    EXPECT_NE(refusal([] { return dODE_MT_SetWorkerPriority("deadline", 1); }).find("round-robin"), std::string::npos);
    EXPECT_NE(refusal([] { return dODE_MT_SetWorkerPriority("normal", 20); }).find("'normal' with 20"), std::string::npos);
    EXPECT_NE(refusal([] { return dODE_MT_SetWorkerStackSize(1); }).find("65536 and more"), std::string::npos);
    EXPECT_NE(refusal([] { return dODE_MT_SetWorkerStackSize(SIZE_MAX); }).find("no worker stack"), std::string::npos);
    EXPECT_NE(refusal([] { return dODE_MT_SetWorkerStackSize(size_t{1} << 60); }).find("the stack size of workers cannot be set: "),
              std::string::npos);
    EXPECT_EQ(dODE_MT_SetThreadManager("openmp"), 1) << "none is set";
    EXPECT_EQ(dODE_MT_SetThreadManager("pthread"), 1);
}

TEST_F(Workers, OptionsThatTheSystemAllows) {
    const int first[] = {0};
    EXPECT_EQ(dODE_MT_SetWorkerAffinity(first, 1), 1);
    EXPECT_EQ(dODE_MT_SetWorkerPriority("idle", 0), 1);
    EXPECT_EQ(dODE_MT_SetWorkerStackSize(100000), 1);
    world.step(20);
    dRandSetSeed(1);
    ChainWorld again(40, 4), serial(40, 4);
    again.step(20);
    OdeSession::use(0, "serial");
    dRandSetSeed(1);
    serial.step(20);
    EXPECT_EQ(again.state(), serial.state());
}

// Those of openmp are the runtime's to start.
TEST_F(Workers, OptionsAndOpenmpExcludeOneAnother) {
    ASSERT_EQ(dODE_MT_SetThreadManager("openmp"), 1);
    EXPECT_NE(refusal([] { return dODE_MT_SetWorkerName("physics"); })
                  .find("the name of workers cannot be set: thread manager 'openmp' has threads of its runtime"),
              std::string::npos);
    EXPECT_NE(refusal([] { return dODE_MT_SetWorkerStackSize(1 << 20); }).find("openmp"), std::string::npos);
    EXPECT_NE(refusal([] { return dODE_MT_SetWorkerHooks(nullptr, nullptr, nullptr); }).find("openmp"), std::string::npos);
    ASSERT_EQ(dODE_MT_SetThreadManager("pthread"), 1);
    EXPECT_EQ(dODE_MT_SetWorkerStackSize(1 << 20), 1);
    EXPECT_NE(refusal([] { return dODE_MT_SetThreadManager("openmp"); }).find("options of workers are set"), std::string::npos);
    EXPECT_STREQ(dODE_MT_GetThreadManager(), "pthread");
    EXPECT_EQ(dODE_MT_SetWorkerStackSize(0), 1);
    EXPECT_EQ(dODE_MT_SetThreadManager("openmp"), 1);
    EXPECT_EQ(dODE_MT_SetThreadManager("pthread"), 1);
}

struct Hooked {
    std::atomic<int> starts{0}, ends{0}, wrong{0};
};

TEST_F(Workers, HooksMayUseOde) {
    Hooked hooked;
    const auto start = [](void *data, int worker) {
        Hooked &own = *static_cast<Hooked *>(data);
        own.wrong += worker < 1 || worker > 2;
        dAllocateODEDataForThread(dAllocateMaskAll);
        ChainWorld(4, 2, dWorldStep).step(2);  // on this thread alone
        ++own.starts;
    };
    const auto end = [](void *data, int) {
        dCleanupODEAllDataForThread();
        ++static_cast<Hooked *>(data)->ends;
    };
    EXPECT_EQ(dODE_MT_SetWorkerHooks(start, end, &hooked), 1);
    useWorkers(world);
    EXPECT_EQ(dODE_MT_SetWorkerHooks(nullptr, nullptr, nullptr), 1);
    EXPECT_GE(hooked.starts, 1);
    EXPECT_EQ(hooked.ends, hooked.starts);
    EXPECT_EQ(hooked.wrong, 0);
}

TEST_F(Workers, HooksDoNotEndWorkers) {
    Hooked hooked;
    testing::internal::CaptureStderr();
    const auto start = [](void *data, int) {
        Hooked &own = *static_cast<Hooked *>(data);
        dToggleODE_MT(2);
        own.wrong += dODE_MT_SetThreadManager("pthread") != 0;
        own.wrong += dODE_MT_SetWorkerName("physics") != 0;
        dODE_MT_SetExecutor(nullptr, nullptr);
        dToggleODE_MT(3);
        ++own.starts;
    };
    EXPECT_EQ(dODE_MT_SetWorkerHooks(start, nullptr, &hooked), 1);
    EXPECT_TRUE(waitUntil(
        [&] {
            world.step();
            return hooked.starts > 0;
        },
        30));
    EXPECT_EQ(dODE_MT_SetWorkerHooks(nullptr, nullptr, nullptr), 1);
    EXPECT_NE(testing::internal::GetCapturedStderr().find("a hook of a worker cannot end workers"), std::string::npos);
    EXPECT_EQ(hooked.wrong, 0);
}

// They would end workers: each is refused whole, as the number in force tells.
TEST_F(Workers, HooksSetNoOtherNumberOfThreads) {
    struct Asked : Hooked {
        ChainWorld own{2, 1};
        dSpaceID space = dSimpleSpaceCreate(nullptr);
    } asked;
    testing::internal::CaptureStderr();
    const auto start = [](void *data, int) {
        Asked &own = *static_cast<Asked *>(data);
        dToggleODE_MT(5);
        own.wrong += dODE_MT_GetThreads() != 3;
        own.wrong += dODE_MT_SetWorldThreads(own.own.world(), 6) != 0;
        own.wrong += dODE_MT_GetWorldThreads(own.own.world()) != 3;
        own.wrong += dODE_MT_SetWorldThreads(own.own.world(), 0) != 1;  // as it is
        dODE_MT_SetSpaceThreads(own.space, 7);
        own.wrong += dODE_MT_GetSpaceThreads(own.space) != 3;
        ++own.starts;
    };
    EXPECT_EQ(dODE_MT_SetWorkerHooks(start, nullptr, &asked), 1);
    EXPECT_TRUE(waitUntil(
        [&] {
            world.step();
            return asked.starts > 0;
        },
        30));
    EXPECT_EQ(dODE_MT_SetWorkerHooks(nullptr, nullptr, nullptr), 1);
    EXPECT_NE(testing::internal::GetCapturedStderr().find("a hook of a worker cannot end workers"), std::string::npos);
    EXPECT_EQ(asked.wrong, 0);
    dSpaceDestroy(asked.space);
}

// The last close waits for workers, also for one that is in its hook, which wants the library's lock.
TEST_F(Workers, CloseWaitsForHooksThatAllocateData) {
    if (kThreadSanitizer) GTEST_SKIP() << "ThreadSanitizer cannot start threads in the child";
    EXPECT_TRUE(support::trueInChild([] {
        Hooked hooked;
        for (int i = 0; i < 200; ++i) {
            dODE_MT_SetWorkerHooks(
                [](void *data, int) {
                    dAllocateODEDataForThread(dAllocateMaskAll);
                    ++static_cast<Hooked *>(data)->starts;
                },
                [](void *data, int) {
                    dCleanupODEAllDataForThread();
                    ++static_cast<Hooked *>(data)->ends;
                },
                &hooked);
            ChainWorld(40, 4, dWorldStep).step();
            dCloseODE();
            if (hooked.starts != hooked.ends) return false;
            dInitODE2(0);
        }
        return hooked.starts > 0;
    }));
}

}  // namespace
