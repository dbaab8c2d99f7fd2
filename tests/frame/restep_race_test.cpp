// The same 50 frames, 100 times from one state in the middle of churn (1000 times with ODE_MT_EXACTNESS=thorough), on 2, 3 and 8
// workers, must have the same bits.
//
// Each run is a fork of the process that holds the state, so that everything is as it was, also what the library keeps from
// call to call. Two workers are tried as well as eight because more of them hide races (Box2D has seen that). Every other
// run has a disturbed schedule.
#include <gtest/gtest.h>
#include <ode/ode.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdint>

#include "ChurnWorld.h"
#include "OdeSession.h"
#include "sanitizers.h"
#include "thorough.h"
#include "threading/dxSchedulePoints.h"

namespace {

constexpr int kFrames = 50;

int numberOfRuns() {
    if (kAddressSanitizer || kThreadSanitizer) return 20;
    return exactness::isThorough() ? 1000 : 100;
}

struct Result {
    std::uint64_t hash;
    unsigned workers, contactsAhead;
};

// What a fork of this process gets to; hash 0: it did not end in time, or crashed.
Result replay(ChurnWorld &world, int run) {
    constexpr unsigned kLimit = 60;  // s
    int ends[2];
    if (pipe(ends) != 0) return {};
    const pid_t child = fork();
    if (child == 0) {
        alarm(kLimit);
        if (run % 2 == 1) dxSetRandomPerturbation(static_cast<unsigned>(run));
        world.frames(kFrames);
        const Result result{world.hash(), dODE_MT_GetMaxWorkersUsed(), dODE_MT_GetContactsAhead()};
        _exit(write(ends[1], &result, sizeof result) == sizeof result ? 0 : 1);
    }
    close(ends[1]);
    Result result{};
    if (read(ends[0], &result, sizeof result) != sizeof result) result = {};
    close(ends[0]);
    waitpid(child, nullptr, 0);
    return result;
}

class RestepRace : public testing::TestWithParam<int> {};

TEST_P(RestepRace, EndsInOneHash) {
    const OdeSession session(0, "serial");
    ChurnWorld world;
    world.frames(30);
    const std::uint64_t serial = replay(world, 0).hash;
    ASSERT_NE(serial, 0u);
    OdeSession::use(GetParam(), "lcp");
    const int runs = numberOfRuns();
    int shared = 0;
    for (int run = 0; run < runs; ++run) {
        const Result result = replay(world, run);
        ASSERT_EQ(result.hash, serial) << "run " << run;
        shared += result.workers > 1 && result.contactsAhead > 0;
    }
    EXPECT_GT(shared, runs / 10) << "workers have come too late for nearly all runs";
}

INSTANTIATE_TEST_SUITE_P(Workers, RestepRace, testing::Values(2, 3, 8));

}  // namespace
