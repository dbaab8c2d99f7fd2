// Memory is refused to the coordinator, to its communication thread or to workers, request by request: while workers connect, during a step, or
// while they are dropped. A step has the bits of steps without workers, or says std::bad_alloc and may be made again. It does not wait for an
// answer that cannot come. The next workers are used as if nothing had been.
//
// Has found: std::bad_alloc on the communication thread ended the process.
#include <gtest/gtest.h>
#include <ode/ode_MT.h>

#include <new>

#include "../dynamics/random_world.h"
#include "../faults/failing_memory.h"
#include "core/dxLog.h"
#include "core/dxStopwatch.h"
#include "remote/islands/dxPackedSolver.h"
#include "remote/islands/dxRemoteIslands.h"
#include "loopback_transport.h"

namespace {

using faults::Shortage;
using States = std::vector<std::vector<std::uint64_t>>;

enum class Phase { Open, Step, Close };

struct Kind {
    Phase phase;
    Shortage shortage;
    int threads;
};

constexpr RandomWorld::Shape kManyIslands{60, 55};
constexpr int kSteps = 3, kStepOfShortage = 1;
constexpr double kMaxStepNs = 1.5e9;  // less than a step that is forced to workers waits for one that is not heard of

std::string nameOf(const testing::TestParamInfo<Kind> &info) {
    constexpr const char *phases[] = {"Open", "Step", "Close"};
    const char *const shortage = info.param.shortage == Shortage::once ? "Once" : "Lasting";
    return std::string(phases[static_cast<int>(info.param.phase)]) + shortage + "Threads" + std::to_string(info.param.threads);
}

class RemoteAllocation : public testing::TestWithParam<Kind> {
protected:
    RemoteAllocation() {
        dInitODE2(0);
        dxRemoteSolvers::install(dxRemoteIslandSolvers());
        dODE_MT_SetAlgorithm("lcp");
        dToggleODE_MT(GetParam().threads);
        dxSetLogLevel(dxLogLevel::Error);
    }
    ~RemoteAllocation() override {
        dxRemoteWorkers::instance().close();
        dxSetLogLevel(dxLogLevel::Warning);
        dToggleODE_MT(0);
        dODE_MT_SetAlgorithm("auto");
        dCloseODE();
    }

    // Requests are refused from the one of this number on in this phase, if it is the one that is tested. Returns how many were made.
    template <class Function>
    long during(Phase phase, long first, Function function) {
        if (phase != GetParam().phase || first < 0) {
            function();
            return 0;
        }
        faults::arm(faults::Source::operatorNew, first, GetParam().shortage);
        function();
        return faults::disarm();
    }

    long open(long first) {
        return during(Phase::Open, first, [] {
            try {
                dxRemoteWorkers::instance().open("loopback", dxDescribeSolver(), [](std::string &) {
                    return std::make_unique<LoopbackTransport>(2, dxDescribeSolver(), dxSolvePacked);
                });
            } catch (const std::bad_alloc &) {
            }
        });
    }

    long run(long first, States &states) {
        constexpr unsigned kSeed = 5;
        dRandSetSeed(kSeed);
        RandomWorld world(kManyIslands, kSeed);
        long requests = 0;
        states.clear();
        for (int i = 0; i < kSteps; ++i) {
            world.push();
            bool isRefused = false;
            const dxStopwatch stopwatch;
            const auto step = [&world, &isRefused] {
                try {
                    dWorldStep(world.world(), dReal(0.01));
                } catch (const std::bad_alloc &) {
                    faults::disarm();
                    isRefused = true;
                }
            };
            requests += i == kStepOfShortage ? during(Phase::Step, first, step) : during(Phase::Step, -1, step);
            if (isRefused) dWorldStep(world.world(), dReal(0.01));
            EXPECT_LT(stopwatch.ns(), kMaxStepNs) << "request " << first;
            states.push_back(world.state());
        }
        return requests;
    }
};

TEST_P(RemoteAllocation, RefusedOnceOrUntilTheEnd) {
    States expected, states;
    run(-1, expected);
    open(-1);
    run(-1, states);  // what is made once in a process is there
    ASSERT_EQ(states, expected);
    dxRemoteWorkers::instance().close();

    constexpr long kDense = 60;  // the first ones are all refused, of the others one in seven
    int reached = 0;
    for (long first = 0, missed = 0; missed < 3; first += first < kDense ? 1 : 7) {
        long requests = open(first);
        requests += run(first, states);
        EXPECT_EQ(states, expected) << "request " << first;
        requests += during(Phase::Close, first, [] { dxRemoteWorkers::instance().close(); });
        if (requests > first) {
            ++reached;
            missed = 0;
        } else {
            ++missed;
        }
        if (HasFailure()) break;
    }
    RecordProperty("requests", reached);
    std::printf("%d requests refused\n", reached);
    EXPECT_GT(reached, GetParam().phase == Phase::Close ? 2 : 30);

    const std::uint64_t before = dxRemoteWorkers::instance().counts().outcomes.solved();
    open(-1);
    EXPECT_EQ(dxRemoteWorkers::instance().capacity().workers, 2u);
    run(-1, states);
    EXPECT_EQ(states, expected);
    EXPECT_GT(dxRemoteWorkers::instance().counts().outcomes.solved(), before);
}

INSTANTIATE_TEST_SUITE_P(, RemoteAllocation,
                         testing::Values(Kind{Phase::Open, Shortage::once, 0}, Kind{Phase::Open, Shortage::lasting, 0},
                                         Kind{Phase::Step, Shortage::once, 0}, Kind{Phase::Step, Shortage::lasting, 0},
                                         Kind{Phase::Step, Shortage::once, 2}, Kind{Phase::Step, Shortage::lasting, 2},
                                         Kind{Phase::Close, Shortage::once, 0}, Kind{Phase::Close, Shortage::lasting, 0}),
                         nameOf);

}  // namespace
