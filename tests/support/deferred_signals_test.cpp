#include "support/deferred_signals.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <csignal>

#include "support/child_run.h"

using namespace support;
using namespace std::chrono_literals;

namespace {

bool isReady(const Descriptor &file, int milliseconds) {
    pollfd wait{file.number(), POLLIN, 0};
    return poll(&wait, 1, milliseconds) == 1;
}

}  // namespace

TEST(DeferredSignals, WaitUntilTheyAreAskedFor) {
    EXPECT_TRUE(trueInChild([] {
        deferSignals();
        const Descriptor file = signalFile();
        if (isReady(file, 0) || waitForSignal(0ms) != 0) return false;
        kill(getpid(), SIGTERM);
        return isReady(file, 0) && waitForSignal(0ms) == SIGTERM && !isReady(file, 0) && waitForSignal(10ms) == 0;
    }));
}

TEST(DeferredSignals, TheEndOfAChildIsOneOfThemAlsoWhereItWasIgnored) {
    EXPECT_TRUE(trueInChild([] {
        signal(SIGCHLD, SIG_IGN);
        deferSignals();
        const Descriptor file = signalFile();
        const pid_t child = spawn({"true"}, {}, {});
        return isReady(file, 10'000) && waitForSignal(0ms) == SIGCHLD && endingOf(waitFor(child)) == "exit code 0";
    }));
}

TEST(DeferredSignals, AreNotDeferredInAProgramThatLeadsItsGroup) {
    EXPECT_TRUE(trueInChild([] {
        deferSignals();
        const pid_t child = spawn({"sleep", "60"}, {}, {}, Group::Own);
        kill(child, SIGTERM);
        return endingOf(waitFor(child)) == "signal 15 (Terminated)";
    }));
}
