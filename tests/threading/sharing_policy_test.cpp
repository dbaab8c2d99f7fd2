// dxSharingPolicy: takes the faster way, does not spend much on finding out, and follows when times change.
#include <gtest/gtest.h>

#include <thread>

#include "threading/payoff/dxSharingPolicy.h"

namespace {

class SharingPolicy : public testing::Test {
protected:
    // Calls that take so long either way; how many of them were shared.
    int shared(int calls, double aloneNs, double sharedNs) {
        int count = 0;
        for (int i = 0; i < calls; ++i) {
            const bool shares = policy.shouldShare();
            count += shares;
            policy.record(shares, shares ? sharedNs : aloneNs);
        }
        return count;
    }

    // How many of forty calls are shared in a scene that has grown until then by `growth` from call to call; `part`: of the time alone that a shared
    // call takes.
    int sharedAfterGrowing(double growth, double part) {
        double aloneNs = 20e3;
        for (; aloneNs < 20e6; aloneNs *= growth) shared(1, aloneNs, part * aloneNs);
        return shared(40, aloneNs, part * aloneNs);
    }

    // The same, where one shared call in `oneIn` takes longer by a time slice of the scheduler's, for which a worker waits. Returns the time
    // of all calls in parts of the time alone.
    double timeWithLateWorkers(int calls, double aloneNs, double sharedNs, int oneIn) {
        constexpr double kTimeSlice = 20e6;  // ns
        double ns = 0;
        for (int i = 0, count = 0; i < calls; ++i) {
            const bool shares = policy.shouldShare();
            const bool isLate = shares && ++count % oneIn == 0;
            const double took = shares ? sharedNs + (isLate ? kTimeSlice : 0) : aloneNs;
            ns += took;
            policy.record(shares, took);
        }
        return ns / (calls * aloneNs);
    }

    dxSharingPolicy policy;
};

TEST_F(SharingPolicy, NeverSharesWhatIsDoneBeforeAWorkerWakes) { EXPECT_EQ(shared(5000, 10e3, 1e3), 0); }

TEST_F(SharingPolicy, SharesWhatPays) {
    EXPECT_GT(shared(100, 400e3, 250e3), 85);
    EXPECT_GT(shared(1000, 400e3, 250e3), 950);
}

TEST_F(SharingPolicy, SeldomProbesWhatDoesNotPay) {
    EXPECT_GT(shared(100, 400e3, 500e3), 0);
    EXPECT_LT(shared(2000, 400e3, 500e3), 60);
}

TEST_F(SharingPolicy, GivesUpWhatNoLongerPaysAndComesBack) {
    shared(300, 400e3, 250e3);
    EXPECT_LT(shared(1000, 400e3, 700e3), 450);
    EXPECT_GT(shared(4000, 400e3, 250e3), 2500);
}

TEST_F(SharingPolicy, FollowsASceneThatGrows) {
    shared(10, 400e3, 500e3);  // a probe that does not pay
    int count = 0;
    double aloneNs = 400e3;
    for (int i = 0; i < 40; ++i, aloneNs *= 1.02) count += shared(1, aloneNs, 500e3);
    EXPECT_GT(count, 10) << "from the twelfth call on it pays, and the next probe would come after the fortieth";
}

// As a wall that has been dropped: each call of its first dozens takes longer than the one before.
TEST_F(SharingPolicy, DoubtsAProbeDuringWhichTheSceneHasGrown) {
    for (const double growth : {1.2, 1.5, 2.0, 3.0}) {
        SCOPED_TRACE(growth);
        policy = {};
        EXPECT_GT(sharedAfterGrowing(growth, 0.6), 28);
    }
}

TEST_F(SharingPolicy, DoubtsNothingInASceneThatGrowsIfSharingDoesNotPay) {
    for (const double growth : {1.2, 1.5, 2.0, 3.0}) {
        SCOPED_TRACE(growth);
        policy = {};
        EXPECT_LT(sharedAfterGrowing(growth, 1.05), 12);
    }
}

TEST_F(SharingPolicy, EndsAProbeAloneThatIsHopeless) {
    shared(1000, 400e3, 200e3);
    EXPECT_GE(shared(2000, 400e3, 200e3), 1997) << "one call for each of two or three probes";
    shared(1000, 400e3, 300e3);
    EXPECT_LE(shared(2000, 400e3, 300e3), 1994) << "three calls each";
}

TEST_F(SharingPolicy, IsToldHowManyCallsAreCold) {
    const auto sharedOf = [this](int cold, int calls) {
        int count = 0, inRow = 0;
        for (int i = 0; i < calls; ++i) {
            inRow = policy.shouldShare() ? inRow + 1 : 0;
            count += shared(1, 400e3, inRow <= cold ? 800e3 : 250e3);
        }
        return count;
    };
    EXPECT_LT(sharedOf(3, 40), 10);
    policy = {8, 3};
    EXPECT_GT(sharedOf(3, 40), 30);
    policy = {8, 3};
    EXPECT_LT(sharedOf(10, 2000), 100) << "what is slow for longer is not worth while";
}

TEST_F(SharingPolicy, CallsThatWereHeldUpSayNothing) {
    int count = 0;
    for (int i = 0; i < 5000; ++i) {
        const double heldUp = (i * 37) % 20 == 0 ? 3 : 1;  // one call in twenty
        count += shared(1, 400e3 * heldUp, 700e3 * heldUp);
    }
    EXPECT_LT(count, 150);
}

TEST_F(SharingPolicy, StaysAloneWhenTheSpaceHasBecomeSmall) {
    shared(300, 400e3, 250e3);
    shared(1000, 5e3, 30e3);
    EXPECT_EQ(shared(1000, 5e3, 30e3), 0);
}

// How many of the calls, all alone, are timed.
int timedCalls(dxSharingPolicy &policy, int calls, double ns) {
    int count = 0;
    for (int i = 0; i < calls; ++i) {
        if (!policy.shouldTimeAlone()) continue;
        ++count;
        policy.record(false, ns);
    }
    return count;
}

TEST_F(SharingPolicy, TimesFewOfTheShortestCalls) {
    const int calls = 1600;
    EXPECT_LT(timedCalls(policy, calls, 1e3), calls / 15);
    EXPECT_GT(timedCalls(policy, calls, 1e3), calls / 20);
    EXPECT_GT(timedCalls(policy, calls, 12e3), calls - 50) << "a scene that has grown is noticed";
    EXPECT_GT(shared(100, 400e3, 250e3), 85);
}

TEST_F(SharingPolicy, LosesLittleWhereWorkersComeLate) {
    EXPECT_LT(timeWithLateWorkers(5000, 100e3, 60e3, 1), 1.10);
    EXPECT_LT(timeWithLateWorkers(50000, 100e3, 60e3, 1), 1.06);
}

TEST_F(SharingPolicy, LosesLittleWhereWorkersComeLateNowAndThen) {
    for (const int oneIn : {2, 3, 5, 9, 20, 50}) {
        SCOPED_TRACE(oneIn);
        policy = {};
        EXPECT_LT(timeWithLateWorkers(50000, 100e3, 60e3, oneIn), 1.10);
    }
}

TEST_F(SharingPolicy, IsProbedAgainWhenWorkersComeInTimeAgain) {
    timeWithLateWorkers(5000, 100e3, 60e3, 3);
    EXPECT_LT(timeWithLateWorkers(50000, 100e3, 60e3, 100000), 0.9);
}

TEST_F(SharingPolicy, OneLateWorkerDoesNotEndWhatPays) {
    shared(1000, 400e3, 250e3);
    shared(1, 20e6, 20e6);
    EXPECT_GT(shared(2000, 400e3, 250e3), 1500);
}

// Steps of worlds of several sizes, in turns.
TEST_F(SharingPolicy, ComparesTheTimeOfAUnitOfWork) {
    constexpr double kNsOfUnit = 100, kSharedPart = 0.6;
    int shared[2] = {}, calls[2] = {};
    for (int i = 0; i < 2000; ++i) {
        const int kind = i % 2;
        const double work = kind == 0 ? 100 : 4000;  // 10 us and 400 us alone
        const bool shares = policy.shouldShare(work);
        shared[kind] += shares;
        ++calls[kind];
        policy.record(shares, work * kNsOfUnit * (shares ? kSharedPart : 1), work);
    }
    EXPECT_EQ(shared[0], 0) << "it is done before a worker wakes";
    EXPECT_GT(shared[1], 0.9 * calls[1]);
}

TEST(ProcessSharingPolicy, ServesEveryThreadAndMakesNoneWait) {
    dxProcessSharingPolicy policy;
    constexpr double kWork = 400e3;
    const auto step = [&policy] {
        for (int i = 0; i < 2000; ++i) {
            const bool shares = policy.ask(kWork) == dxProcessSharingPolicy::Answer::Shared;
            policy.record(shares, shares ? 0.6 * kWork : kWork, kWork);
        }
    };
    std::thread other(step);
    step();
    other.join();
    EXPECT_EQ(policy.ask(kWork), dxProcessSharingPolicy::Answer::Shared);
}

}  // namespace
