// Parallel sweeps give the bits of one thread's, wherever the bodies lie and on any number of threads.
#include "dynamics/quick_step/sor/dxParallelSor.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include "random_sor_island.h"

namespace {

using Limits = std::numeric_limits<dReal>;

// A thread for each block, or the calling thread for all of them.
class Threads final : public dxTaskRunner {
public:
    explicit Threads(bool several) : m_several(several) {}

    unsigned workers() const override { return 16; }
    void run(dxParallelStage stage, unsigned blocks, dxThreadManager::Task task, void *context) override {
        if (!m_several) return dxTaskRunner::alone().run(stage, blocks, task, context);
        std::vector<std::thread> threads;
        for (unsigned block = 1; block < blocks; ++block) threads.emplace_back(task, context, block, block);
        task(context, 0, 0);
        for (std::thread &thread : threads) thread.join();
    }

private:
    bool m_several;
};

// By parts, and by whether each has a thread of its own.
class ParallelSor : public testing::TestWithParam<std::tuple<unsigned, bool>> {
protected:
    static void expectSame(Size size, dReal (*coordinate)(std::size_t body, int axis)) {
        const auto [parts, several] = GetParam();
        RandomIsland ours(size.joints, size.bodies, 5 + size.joints, true);
        RandomIsland reference(size.joints, size.bodies, 5 + size.joints, true);
        Threads threads(several);
        dxParallelSor sweep;
        dReal place[3];
        sweep.begin(ours.problem(), parts, [&](std::size_t body) {
            for (int axis = 0; axis < 3; ++axis) place[axis] = coordinate(body, axis);
            return place;
        });
        for (const unsigned times : {8u, 1u, 4u}) {
            ours.shuffle();
            reference.shuffle();
            sweep.sweep(ours.problem(), ours.order.data(), times, threads);
            for (unsigned i = 0; i < times; ++i) sweepOneByOne(reference);
        }
        EXPECT_TRUE(sameState(ours, reference)) << size.joints << " joints";
    }
};

TEST_P(ParallelSor, OfBodiesThatAreCutAnywhereIsThatOfOneThread) {
    for (const Size size : kSizes)
        expectSame(size, [](std::size_t body, int axis) { return dReal(body * 7 % (11 + std::size_t(axis))); });
}

TEST_P(ParallelSor, OfBodiesThatCannotBeCutIsThatOfOneThread) {
    for (const Size size : kSizes) expectSame(size, [](std::size_t, int) { return dReal(1); });
}

TEST_P(ParallelSor, OfBodiesAtPlacesThatAreNoneIsThatOfOneThread) {
    for (const Size size : kSizes)
        expectSame(size, [](std::size_t body, int axis) {
            const dReal places[] = {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(), Limits::max(), dReal(body)};
            return places[(body + std::size_t(axis)) % 5];
        });
}

INSTANTIATE_TEST_SUITE_P(Parts, ParallelSor, testing::Combine(testing::Values(1u, 2u, 3u, 7u, 16u), testing::Bool()),
                         [](const auto &info) {
                             return std::to_string(std::get<0>(info.param)) +
                                    (std::get<1>(info.param) ? "_threads" : "_parts_of_one_thread");
                         });

}  // namespace
