// The system refuses threads: fewer workers, one warning, nothing lost.
//
// Covers dxThreadManagerOpenMP.cpp.
#include <cerrno>

#include "processThreads.h"
#include "Runs.h"
#include "threading/managers/dxThreadManagerOpenMP.h"
#include "threading/managers/dxThreadManagerPthread.h"
#include "threading/pool/dxWorkerThread.h"
#include "threadSanitizer.h"

namespace {

std::atomic<int> threadsLeft{0};

int createWhileAllowed(pthread_t *thread, const pthread_attr_t *attributes, void *(*body)(void *),
                       void *context) {
    if (threadsLeft-- <= 0) return EAGAIN;
    return pthread_create(thread, attributes, body, context);
}

unsigned warningsIn(const std::string &text) {
    unsigned count = 0;
    for (std::size_t at = text.find("ODE_MT warning:"); at != std::string::npos;
         at = text.find("ODE_MT warning:", at + 1)) {
        ++count;
    }
    return count;
}

void expectFallBack(dxThreadManager &manager) {
    const unsigned before = processThreads();
    for (const int allowed : {0, 2}) {
        threadsLeft = allowed;
        manager.resize(6);
        EXPECT_TRUE(allWorkersMeet(manager, allowed + 1)) << allowed << " threads";
        for (int i = 0; i < 10; ++i) EXPECT_TRUE(everyBlockOnce(manager, 100, 6));
        EXPECT_LE(processThreads(), before + allowed);
        manager.stop();
    }
}

TEST(ThreadCreation, RefusedToPthread) {
    dxThreadManagerPthread manager(createWhileAllowed);
    testing::internal::CaptureStderr();
    expectFallBack(manager);
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_EQ(warningsIn(said), 1u) << said;
    EXPECT_NE(said.find("1 of 6 workers"), std::string::npos) << said;

    threadsLeft = 100;
    manager.resize(6);
    EXPECT_TRUE(allWorkersMeet(manager, 6)) << "a resize asks the system again";
}

TEST(ThreadCreation, RefusedToOpenMP) {
    if (underThreadSanitizer) GTEST_SKIP() << "see threadSanitizer.h";
    const auto manager = dxThreadManagerOpenMP::make(createWhileAllowed);
    if (manager == nullptr) GTEST_SKIP() << "no OpenMP runtime on this machine";
    testing::internal::CaptureStderr();
    expectFallBack(*manager);
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_EQ(warningsIn(said), 1u) << said;
}

TEST(ThreadCreation, ProbeCountsWhatExistsAtOnce) {
    int refusal = 0;
    threadsLeft = 3;
    EXPECT_EQ(dxProbeThreads(createWhileAllowed, 5, refusal), 3u);
    EXPECT_EQ(refusal, EAGAIN);
    EXPECT_EQ(dxProbeThreads(pthread_create, 5, refusal), 5u);
    EXPECT_EQ(refusal, 0);
}

}  // namespace
