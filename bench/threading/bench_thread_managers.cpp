// Measures the thread managers: the overhead of a run, and the speed-up of blocks of a given length.
//
//   empty      a run of as many empty blocks as workers: the cost to the caller, who may do them all
//   meeting    the same, but every block waits for all others: all workers are woken and take part
//   blocks     200 blocks of equal length; `speedup` is the median ratio to one worker, measured alternately
//
// `median_us` is the median of the single runs; the time column is their mean.
//
// The second number is the number of workers. `idle` is the pause before the run, in microseconds: 0 finds
// the workers spinning, 1000 and 20000 find them asleep.
#include <benchmark/benchmark.h>
#include <ode/odeinit.h>
#include <ode/threading_impl.h>
#include <sched.h>
#include <time.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "support/statistics.h"
#include "threading/managers/dxThreadManagerFactory.h"
#include "threading/managers/dxThreadManagerUser.h"

namespace {

using Clock = std::chrono::steady_clock;

// One pool of ODE's per number of threads, kept until the end.
std::shared_ptr<dxThreadManager> makeUser(unsigned workers) {
    static std::map<unsigned, std::shared_ptr<dxThreadManager>> managers;
    std::shared_ptr<dxThreadManager> &manager = managers[workers];
    if (!manager) {
        const dThreadingImplementationID implementation = dThreadingAllocateMultiThreadedImplementation();
        dThreadingThreadPoolServeMultiThreadedImplementation(
            dThreadingAllocateThreadPool(workers, 0, dAllocateFlagBasicData, nullptr), implementation);
        manager = std::make_shared<dxThreadManagerUser>(dThreadingImplementationGetFunctions(implementation),
                                                        implementation);
    }
    return manager;
}

std::shared_ptr<dxThreadManager> make(const std::string &name, unsigned workers) {
    std::shared_ptr<dxThreadManager> manager =
        name == "user" ? makeUser(workers)
                       : std::shared_ptr<dxThreadManager>(dxThreadManagerFactory::create(name));
    manager->resize(workers);
    return manager;
}

void doNothing(void *, unsigned, unsigned) {}

struct Meeting {
    unsigned expected;
    std::atomic<unsigned> arrived{0};
};

void meet(void *context, unsigned, unsigned) {
    Meeting &meeting = *static_cast<Meeting *>(context);
    meeting.arrived.fetch_add(1);
    while (meeting.arrived.load() < meeting.expected) sched_yield();
}

void sleepMicroseconds(long microseconds) {
    const timespec pause{0, microseconds * 1000};
    nanosleep(&pause, nullptr);
}

template <typename Function>
double seconds(Function function) {
    const Clock::time_point start = Clock::now();
    function();
    return std::chrono::duration<double>(Clock::now() - start).count();
}

void dispatch(benchmark::State &state, const std::string &name, bool all) {
    const unsigned workers = static_cast<unsigned>(state.range(0));
    const auto manager = make(name, workers);
    const auto run = [&] {
        Meeting meeting{workers};
        manager->run(workers, workers, all ? meet : doNothing, &meeting);
    };
    run();
    std::vector<double> times;
    times.reserve(state.max_iterations);
    for (auto _ : state) {
        if (state.range(1) > 0) sleepMicroseconds(state.range(1));
        times.push_back(seconds(run));
        state.SetIterationTime(times.back());
    }
    state.counters["median_us"] = 1e6 * support::median(times);
}

// Work that needs the processor and nothing else: dependent multiplications.
void multiply(void *context, unsigned, unsigned) {
    double value = 1;
    for (long i = *static_cast<long *>(context); i > 0; --i) benchmark::DoNotOptimize(value *= 1.0000001);
}

long multiplicationsPerMicrosecond() {
    static const long rate = [] {
        long many = 20000000;
        multiply(&many, 0, 0);
        return static_cast<long>(many / (1e6 * seconds([&] { multiply(&many, 0, 0); })));
    }();
    return rate;
}

void blocks(benchmark::State &state, const std::string &name) {
    constexpr unsigned count = 200;
    const unsigned workers = static_cast<unsigned>(state.range(0));
    const auto manager = make(name, workers);
    long length = state.range(1) * multiplicationsPerMicrosecond();
    manager->run(count, workers, multiply, &length);
    std::vector<double> ratios;
    for (auto _ : state) {
        const double alone = seconds([&] { manager->run(count, 1, multiply, &length); });
        const double shared = seconds([&] { manager->run(count, workers, multiply, &length); });
        state.SetIterationTime(shared);
        ratios.push_back(alone / shared);
    }
    state.counters["speedup"] = support::median(ratios);
}

void registerManager(const std::string &name) {
    for (const bool all : {false, true}) {
        // Enough runs for a stable mean, and no more than a second of pauses.
        for (const auto &[idle, runs] : {std::pair{0, 5000}, {1000, 500}, {20000, 50}}) {
            benchmark::RegisterBenchmark((name + (all ? "/meeting" : "/empty")).c_str(), dispatch, name, all)
                ->ArgNames({"workers", "idle"})
                ->ArgsProduct({{1, 2, 4, 8}, {idle}})
                ->Iterations(runs)
                ->UseManualTime()
                ->Unit(benchmark::kMicrosecond);
        }
    }
    benchmark::RegisterBenchmark((name + "/blocks").c_str(), blocks, name)
        ->ArgNames({"workers", "us"})
        ->ArgsProduct({{2, 4, 8}, {1, 10, 100}})
        ->UseManualTime()
        ->MinTime(0.1)
        ->Unit(benchmark::kMicrosecond);
}

}  // namespace

int main(int argc, char **argv) {
    dInitODE2(0);
    for (const char *name : dxThreadManagerFactory::names()) registerManager(name);
    registerManager("user");
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
}
