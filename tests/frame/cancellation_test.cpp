// A thread that has been cancelled continues until its own next cancellation point: upstream's computations have none.
#include <gtest/gtest.h>
#include <ode/ode.h>
#include <pthread.h>

#include "support/child_run.h"
#include "HeapWorld.h"
#include "sanitizers.h"

namespace {

// What a thread does while its cancellation is pending.
enum class Work { frames, otherThreads, noThreads, otherManager, close };

constexpr const char *kNames[] = {"Frames", "OtherThreads", "NoThreads", "OtherManager", "Close"};

struct Pending {
    Work work;
    HeapWorld *world;
    bool isThrough = false;
};

void frames(HeapWorld &world) {
    for (int i = 0; i < 5; ++i) {
        world.collide();
        world.step();
    }
}

void *workCancelled(void *context) {
    Pending &pending = *static_cast<Pending *>(context);
    pthread_cancel(pthread_self());
    switch (pending.work) {
        case Work::frames:
            frames(*pending.world);
            break;
        case Work::otherThreads:
            dToggleODE_MT(5);
            frames(*pending.world);
            break;
        case Work::noThreads:
            dToggleODE_MT(0);
            break;
        case Work::otherManager:
            dODE_MT_SetThreadManager("pthread");
            frames(*pending.world);
            dODE_MT_SetThreadManager("openmp");
            frames(*pending.world);
            break;
        case Work::close:
            dCloseODE();
            break;
    }
    pending.isThrough = true;
    pthread_testcancel();
    return nullptr;
}

class Cancellation : public testing::TestWithParam<std::tuple<const char *, Work>> {
protected:
    void SetUp() override {
        const auto [manager, work] = GetParam();
        skipIfUnseen(work == Work::otherManager ? "openmp" : manager);
    }
};

TEST_P(Cancellation, ComesAtThePointOfTheProgram) {
    EXPECT_TRUE(support::trueInChild([] {
        const auto [manager, work] = GetParam();
        dInitODE2(0);
        dODE_MT_SetThreadManager(manager);
        dToggleODE_MT(3);
        dODE_MT_SetAlgorithm("lcp");
        HeapWorld world(dHashSpaceCreate(nullptr));
        // The first run of a manager makes its threads, a later one finds them.
        for (int i = 0; i < 2; ++i) {
            Pending pending{work, &world};
            pthread_t thread;
            void *result = nullptr;
            pthread_create(&thread, nullptr, workCancelled, &pending);
            pthread_join(thread, &result);
            if (!pending.isThrough || result != PTHREAD_CANCELED) return false;
            if (work == Work::close) dInitODE2(0);
            frames(world);
        }
        return true;
    }));
}

INSTANTIATE_TEST_SUITE_P(
    While, Cancellation,
    testing::Combine(testing::Values("pthread", "openmp"),
                     testing::Values(Work::frames, Work::otherThreads, Work::noThreads, Work::otherManager, Work::close)),
    [](const auto &info) {
        return std::get<0>(info.param) + std::string(kNames[static_cast<int>(std::get<1>(info.param))]);
    });

}  // namespace
