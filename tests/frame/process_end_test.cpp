// The process ends while callbacks are running: in one of them, or because main returns. Each child has 20 s for it.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <atomic>
#include <cstdlib>
#include <mutex>
#include <string>
#include <thread>

#include "support/child_run.h"
#include "Deadline.h"
#include "OdeSession.h"
#include "SphereRows.h"
#include "sanitizers.h"

namespace {

constexpr int kStatus = 7;

enum class Where { Caller, Worker };

// What the callback does, on which of its threads; the other one is then inside a callback, too.
struct Plan {
    Where where;
    void (*action)();
    std::thread::id caller = std::this_thread::get_id();
    std::atomic<bool> workerCame{false};
};

void carryOut(void *data, dGeomID, dGeomID) {
    Plan &plan = *static_cast<Plan *>(data);
    const bool isWorker = std::this_thread::get_id() != plan.caller;
    if (isWorker) plan.workerCame = true;
    if (!comesTrue([&plan] { return plan.workerCame.load(); })) std::_Exit(3);
    if (isWorker == (plan.where == Where::Worker)) plan.action();
    comesTrue([] { return false; });  // until the process ends
}

struct Mode {
    const char *manager;
    Where where;
};

class ProcessEnd : public testing::TestWithParam<Mode> {
protected:
    void SetUp() override { skipIfUnseen(GetParam().manager); }

    support::Ending collide(void (*action)()) {
        return support::runInChild([action] {
            dODE_MT_SetThreadManager(GetParam().manager);
            dODE_MT_SetCallbackPolicy("concurrent");
            const OdeSession session(2, "lcp");
            SphereRows rows(dHashSpaceCreate(nullptr));
            Plan plan{GetParam().where, action};
            dSpaceCollide(rows.space(), &plan, carryOut);
        });
    }
};

TEST_P(ProcessEnd, ByExitInAConcurrentCallback) {
    EXPECT_TRUE(collide([] { std::exit(kStatus); }).exitedWith(kStatus));
}

TEST_P(ProcessEnd, ByErrorInAConcurrentCallback) {
    const support::Ending end = collide([] { dError(5, "enough"); });
    EXPECT_TRUE(end.exitedWith(1));
    EXPECT_NE(end.errors.find("ODE Error 5: enough"), std::string::npos) << end.errors;
}

INSTANTIATE_TEST_SUITE_P(Threads, ProcessEnd,
                         testing::Values(Mode{"pthread", Where::Caller}, Mode{"pthread", Where::Worker},
                                         Mode{"openmp", Where::Caller}, Mode{"openmp", Where::Worker}),
                         [](const auto &info) {
                             return std::string(info.param.manager) +
                                    (info.param.where == Where::Caller ? "Caller" : "Worker");
                         });

// main returns with a lock that the callback of another thread waits for.
class MainReturns : public testing::TestWithParam<const char *> {};

TEST_P(MainReturns, WhileACallbackWaitsForIt) {
    const support::Ending end = support::runInChild([] {
        static std::mutex held;
        static std::atomic<int> inside{0};
        held.lock();
        dODE_MT_SetCallbackPolicy(GetParam());
        OdeSession::use(2, "lcp");
        std::thread([] {
            dInitODE2(0);
            const SphereRows rows(dHashSpaceCreate(nullptr));
            dSpaceCollide(rows.space(), nullptr, [](void *, dGeomID, dGeomID) {
                ++inside;
                const std::lock_guard<std::mutex> wait(held);
            });
        }).detach();
        if (!comesTrue([] { return inside > 0; })) std::_Exit(3);
        std::exit(kStatus);
    });
    EXPECT_TRUE(end.exitedWith(kStatus)) << end.errors;
}

INSTANTIATE_TEST_SUITE_P(Policies, MainReturns, testing::Values("serial", "concurrent"),
                         [](const auto &info) { return info.param; });

}  // namespace
