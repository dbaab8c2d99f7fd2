// What is believed of a worker: when its problems should be back, when it is late, and when it is given problems again.
#include "remote/coordinator/dxRemoteLink.h"

#include <gtest/gtest.h>

#include "remote/coordinator/dxRemoteProblem.h"

namespace {

constexpr double kMs = 1e6;

dxRemoteLink openLink() {
    dxRemoteLink link;
    link.welcome();
    link.setMeasured(0.1 * kMs, 0);
    return link;
}

void send(dxRemoteLink &link, std::uint64_t number, double cost, double now) { link.send({number, {number}, cost, 0, 0}, 0, now); }

// Sent, and back after so long.
void exchange(dxRemoteLink &link, std::uint64_t number, double cost, double took, double &now) {
    send(link, number, cost, now);
    now += took;
    dxRemoteInFlight problems;
    ASSERT_TRUE(link.takeBack(number, now, problems));
}

TEST(RemoteLink, IsFreeOnceItIsMeasured) {
    dxRemoteLink link;
    EXPECT_FALSE(link.isFree(0));
    link.welcome();
    EXPECT_FALSE(link.isFree(0));
    link.setMeasured(1000, 0.1);
    EXPECT_TRUE(link.isFree(0));
    link.lose();
    EXPECT_FALSE(link.isFree(0));
}

TEST(RemoteLink, HasTwoMessagesUnderWay) {
    dxRemoteLink link = openLink();
    send(link, 1, kMs, 0);
    EXPECT_TRUE(link.isFree(0));
    send(link, 2, kMs, 0);
    EXPECT_FALSE(link.isFree(0));
    EXPECT_DOUBLE_EQ(link.inFlight().front().expected, 1.1 * kMs);
    EXPECT_DOUBLE_EQ(link.inFlight().back().expected, 2.2 * kMs);
}

TEST(RemoteLink, LearnsHowSlowTheWorkerIs) {
    dxRemoteLink link = openLink();
    double now = 0;
    for (std::uint64_t i = 0; i < 100; ++i) ASSERT_NO_FATAL_FAILURE(exchange(link, i, kMs, 3.1 * kMs, now));
    EXPECT_NEAR(link.slowness(now), 3, 0.1);
}

// Most of what they take is how long they wait until somebody looks.
TEST(RemoteLink, SmallMessagesTellLittleOfTheWorker) {
    dxRemoteLink link = openLink();
    double now = 0;
    for (std::uint64_t i = 0; i < 100; ++i) {
        const bool isSmall = i % 2 == 0;
        const double cost = isSmall ? 0.02 * kMs : kMs;
        ASSERT_NO_FATAL_FAILURE(exchange(link, i, cost, 0.1 * kMs + cost + (isSmall ? 0.3 * kMs : 0), now));
    }
    EXPECT_LT(link.slowness(now), 2);
}

// One that seems slow is given nothing, so that nothing would tell that it is not.
TEST(RemoteLink, ForgetsThatAWorkerWasSlow) {
    dxRemoteLink link = openLink();
    double now = 0;
    for (std::uint64_t i = 0; i < 100; ++i) ASSERT_NO_FATAL_FAILURE(exchange(link, i, kMs, 20 * kMs, now));
    EXPECT_GT(link.slowness(now), 10);
    EXPECT_GT(link.slowness(now + 500 * kMs), 5);
    EXPECT_LT(link.slowness(now + 20e3 * kMs), 1.1);
    send(link, 100, kMs, now + 20e3 * kMs);
    EXPECT_LT(link.inFlight().front().expected, now + 20e3 * kMs + 2 * kMs + dxPollPause::longestNs(20e9));
}

TEST(RemoteLink, ExpectsLaterWhatHomeFindsToTakeLonger) {
    dxRemoteLink link = openLink();
    constexpr std::uint64_t kOther = dxRemoteNumber(1, 0);
    send(link, 1, kMs, 0);
    link.send({2, {kOther}, kMs, 0, 0}, 0, 0);
    const double deadline = link.deadline();
    link.rescale(0, 10);
    EXPECT_DOUBLE_EQ(link.inFlight().front().expected, 10.1 * kMs);
    EXPECT_DOUBLE_EQ(link.inFlight().back().expected, 11.2 * kMs) << "this step's problems alone";
    EXPECT_GT(link.deadline(), deadline + 17 * kMs);
    const double later = link.deadline();
    link.rescale(0, 0.1);
    EXPECT_DOUBLE_EQ(link.inFlight().front().expected, 1.1 * kMs);
    EXPECT_DOUBLE_EQ(link.deadline(), later) << "no deadline comes nearer";
    double now = 10.1 * kMs;
    link.rescale(0, 10);
    dxRemoteInFlight problems;
    ASSERT_TRUE(link.takeBack(1, now, problems));
    EXPECT_NEAR(link.slowness(now), 1, 1e-9) << "the worker is as fast as home";
}

TEST(RemoteLink, IsLateUntilAllIsBackAndThenPauses) {
    dxRemoteLink link = openLink();
    double now = 0;
    double pause = 0;
    for (std::uint64_t i = 0; i < 4; ++i) {
        send(link, i, kMs, now);
        now = link.deadline();
        EXPECT_FALSE(link.noticeLate(now - 1));
        EXPECT_TRUE(link.noticeLate(now));
        EXPECT_FALSE(link.noticeLate(now)) << "only once";
        EXPECT_FALSE(link.isUsable(now + 1000 * kMs));
        dxRemoteInFlight problems;
        ASSERT_TRUE(link.takeBack(i, now, problems));
        EXPECT_FALSE(link.isUsable(now));
        const double before = now;
        while (!link.isUsable(now)) now += kMs;
        EXPECT_GT(now - before, 1.9 * pause);
        pause = now - before;
    }
}

// A worker that has heard nothing for seconds is not late, nor slow, as it sleeps.
TEST(RemoteLink, ExpectsWhatMeetsASleepingWorkerLater) {
    dxRemoteLink link = openLink();
    link.noteContact(0);
    EXPECT_FALSE(link.isAsleep(100 * kMs));
    double now = 5000 * kMs;
    EXPECT_TRUE(link.isAsleep(now));
    const double sleep = dxPollPause::longestNs(now);
    send(link, 1, kMs, now);
    EXPECT_FALSE(link.isAsleep(now));
    EXPECT_DOUBLE_EQ(link.inFlight().front().expected, now + 1.1 * kMs + sleep);
    EXPECT_GE(link.deadline(), now + 2 * (1.1 * kMs + sleep));
    dxRemoteInFlight problems;
    now += 1.1 * kMs + sleep;
    ASSERT_TRUE(link.takeBack(1, now, problems));
    EXPECT_DOUBLE_EQ(link.slowness(now), 1);
    send(link, 2, kMs, now);
    EXPECT_DOUBLE_EQ(link.inFlight().front().expected, now + 1.1 * kMs);
}

// One that is woken in time looks again as often as ever.
TEST(RemoteLink, KnowsWhenAWorkerIsAwake) {
    dxRemoteLink link = openLink();
    const double woken = 5000 * kMs, sleep = dxPollPause::longestNs(woken);
    link.noteContact(woken);
    EXPECT_FALSE(link.isAsleep(woken));
    send(link, 1, kMs, woken + sleep);
    EXPECT_DOUBLE_EQ(link.inFlight().front().expected, woken + sleep + 1.1 * kMs);
}

TEST(RemoteLink, KnowsWhatItHasSent) {
    dxRemoteLink link = openLink();
    send(link, 5, kMs, 0);
    dxRemoteInFlight problems;
    EXPECT_FALSE(link.takeBack(6, 1, problems));
    EXPECT_TRUE(link.takeBack(5, 1, problems));
    EXPECT_FALSE(link.takeBack(5, 1, problems));
}

// A worker that was stopped while it was measured: what it does not bring back is late after seconds all the same.
TEST(RemoteLink, AnAbsurdMeasurementIsNotBelieved) {
    dxRemoteLink link;
    link.welcome();
    link.setMeasured(60e9, 1e6);
    dxRemoteInFlight problems{1, {1}, 1e6, 0, 0};
    problems.isPatient = true;
    link.send(std::move(problems), 100000, 0);
    EXPECT_LT(link.deadline(), 5e9);
}

}  // namespace
