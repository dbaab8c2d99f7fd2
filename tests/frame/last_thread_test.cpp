// A process ends with its last thread, although workers sleep, remote ones and the thread that talks to them, too: the main thread has ended by
// pthread_exit, no thread calls dCloseODE. A program of its own, because pthread_exit unwinds the stack, which a test runner does not survive.
//
// The program plays one of these processes if it is given its name.
//
// Covers dxProcessThreads.cpp.
#include <gtest/gtest.h>
#include <ode/ode.h>
#include <pthread.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <thread>

#include "sanitizers.h"

namespace {

using std::chrono::milliseconds;

constexpr int kStatus = 7;    // of a process that ends as it should
constexpr int kTooEarly = 3;  // of one that does not wait for its threads
constexpr int kSerial = 4;    // of one in which no worker took part
constexpr int kAlone = 5;     // of one without the remote workers that it asks for
bool isOver = false;

// Unconnected bodies are islands of one body each. On a busy machine a worker may come too late for many steps.
void stepInParallel() {
    const dWorldID world = dWorldCreate();
    for (int i = 0; i < 500; ++i) dBodyCreate(world);
    const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    do dWorldQuickStep(world, 0.01);
    while (dODE_MT_GetMaxWorkersUsed() < 2 && std::chrono::steady_clock::now() < limit);
    dWorldDestroy(world);
    if (dODE_MT_GetMaxWorkersUsed() < 2) std::_Exit(kSerial);
}

void begin() {
    std::atexit([] { std::_Exit(isOver ? kStatus : kTooEarly); });
    dInitODE2(0);
    dODE_MT_SetThreadManager("pthread");
    dToggleODE_MT(4);
    dODE_MT_SetAlgorithm("lcp");
    stepInParallel();
}

void limitDescriptors(rlim_t count) {
    rlimit limit;
    getrlimit(RLIMIT_NOFILE, &limit);
    limit.rlim_cur = std::min(count, limit.rlim_max);
    setrlimit(RLIMIT_NOFILE, &limit);
}

// Longer than the workers wait before they look around, and once more after a pause as long.
void goOn() {
    for (int i = 0; i < 2; ++i) {
        std::this_thread::sleep_for(milliseconds(2500));
        stepInParallel();
    }
    isOver = true;
    limitDescriptors(RLIM_INFINITY);  // where there was a lower limit that can be raised
}

// The list of threads can be opened then, and what it lists cannot.
void leaveOneDescriptor() {
    const int lowest = dup(STDERR_FILENO);
    close(lowest);
    limitDescriptors(static_cast<rlim_t>(lowest) + 1);
}

void play(const char *name) {
    begin();
    if (std::strstr(name, "with_remote_workers") != nullptr) {
        dODE_MT_RemoteStatistics remote{};
        remote.size = sizeof remote;
        dODE_MT_GetRemoteStatistics(&remote);
        if (remote.workers != 2) std::_Exit(kAlone);
    }
    if (std::strstr(name, "without_files") != nullptr) {
        const rlimit none{3, 3};
        setrlimit(RLIMIT_NOFILE, &none);
    }
    if (std::strstr(name, "and_one_file") != nullptr) leaveOneDescriptor();
    if (std::strstr(name, "other_thread_goes_on") != nullptr)
        std::thread(goOn).detach();
    else
        isOver = true;
    pthread_exit(nullptr);
}

// The exit status; -1: it has not ended within 20 s.
int statusOf(const char *name) {
    const pid_t child = fork();
    if (child == 0) {
        if (std::strstr(name, "with_remote_workers") != nullptr) {
            setenv("ODE_MT_WORKERS", "loopback:2", 1);
            setenv("LD_LIBRARY_PATH", LOOPBACK_FOLDER, 1);
        }
        execl("/proc/self/exe", "last_thread_test", name, nullptr);
        std::_Exit(127);
    }
    for (int i = 0; i < 2000; ++i) {
        int status = 0;
        if (waitpid(child, &status, WNOHANG) == child) return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
        std::this_thread::sleep_for(milliseconds(10));
    }
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    return -1;
}

class LastThread : public testing::TestWithParam<const char *> {};

TEST_P(LastThread, EndsTheProcess) {
    if (kThreadSanitizer) GTEST_SKIP() << "ThreadSanitizer has a thread of its own, which never ends";
    EXPECT_EQ(statusOf(GetParam()), kStatus);
}

INSTANTIATE_TEST_SUITE_P(After, LastThread, testing::Values("main_thread_ends", "other_thread_goes_on", "main_thread_ends_without_files",
                                         "other_thread_goes_on_without_files", "main_thread_ends_with_remote_workers",
                                         "other_thread_goes_on_with_remote_workers",
                                         "other_thread_goes_on_with_remote_workers_and_one_file"),
                         [](const auto &info) { return info.param; });

}  // namespace

int main(int argc, char **argv) {
    if (argc == 2 && argv[1][0] != '-') play(argv[1]);
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
