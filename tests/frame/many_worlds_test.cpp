// Worlds stepped at the same time by threads of the user (contract C7): the bits are those of some order of
// whole steps, one after the other.
//
// Covers dxIslandDraws.cpp, dxIslandSurvey.cpp, dxSerialStep.cpp.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <string>
#include <thread>

#include "ChainWorld.h"
#include "dynamics/step/random/dxRandom.h"
#include "OdeSession.h"
#include "sanitizers.h"

namespace {

struct Mode {
    int threads;
    const char *algorithm;
};

void PrintTo(const Mode &mode, std::ostream *out) { *out << mode.threads << " threads, " << mode.algorithm; }

class ManyWorlds : public testing::TestWithParam<Mode> {
protected:
    OdeSession session{GetParam().threads, GetParam().algorithm};
};

// Numbers that one step of the world draws, found by stepping it once.
unsigned drawsOfAStep(ChainWorld &world) {
    dRandSetSeed(0);
    world.step();
    const std::uint32_t end = static_cast<std::uint32_t>(dRandGetSeed());
    unsigned draws = 0;
    for (std::uint32_t seed = 0; seed != end; seed = dxRandom::next(seed)) ++draws;
    return draws;
}

TEST_P(ManyWorlds, NoRandomNumberIsLostOrDrawnTwice) {
    constexpr unsigned kThreads = 8, kWorlds = 2;
    constexpr unsigned kSteps = kThreadSanitizer || kAddressSanitizer ? 20 : 100;
    std::vector<std::unique_ptr<ChainWorld>> worlds;
    std::uint64_t draws = 0;
    for (unsigned i = 0; i < kThreads * kWorlds; ++i) {
        worlds.push_back(std::make_unique<ChainWorld>(3 + i % 5, 2 + i % 4));
        draws += kSteps * drawsOfAStep(*worlds.back());
    }
    ASSERT_GT(draws, 0u);

    constexpr std::uint32_t kStart = 123;
    dRandSetSeed(kStart);
    std::vector<std::thread> threads;
    for (unsigned t = 0; t < kThreads; ++t) {
        threads.emplace_back([&worlds, t] {
            dAllocateODEDataForThread(dAllocateMaskAll);
            for (unsigned i = 0; i < kSteps; ++i) {
                for (unsigned w = 0; w < kWorlds; ++w) worlds[t * kWorlds + w]->step();
            }
        });
    }
    std::atomic<bool> done{false};
    std::thread initialiser([&done] {
        while (!done) {
            dInitODE2(0);
            ChainWorld(2, 2, dWorldStep).step();
            dCloseODE();
        }
    });
    for (std::thread &thread : threads) thread.join();
    done = true;
    initialiser.join();
    EXPECT_EQ(dRandGetSeed(), dxRandom::jump(kStart, draws));
}

// --- the result is that of one of the orders -------------------------------------------------------------

struct Result {
    std::vector<dReal> first, second;
    unsigned long seed;
    bool operator==(const Result &o) const {
        return seed == o.seed && first == o.first && second == o.second;
    }
};

class TwoWorlds {
public:
    TwoWorlds() : m_first(6, 4), m_second(4, 7) { dRandSetSeed(5); }
    ChainWorld &first() { return m_first; }
    ChainWorld &second() { return m_second; }
    Result result() const { return {m_first.state(), m_second.state(), dRandGetSeed()}; }

private:
    ChainWorld m_first, m_second;
};

// The results of all orders of `steps` steps of each world, one at a time on one thread.
std::vector<Result> resultsOfAllOrders(unsigned steps) {
    std::vector<Result> results;
    std::string order = std::string(steps, '1') + std::string(steps, '2');
    do {
        TwoWorlds worlds;
        for (const char which : order) (which == '1' ? worlds.first() : worlds.second()).step();
        results.push_back(worlds.result());
    } while (std::next_permutation(order.begin(), order.end()));
    return results;
}

TEST_P(ManyWorlds, ResultIsThatOfSomeOrderOfWholeSteps) {
    constexpr unsigned kSteps = 3;
    constexpr unsigned kRepetitions = kThreadSanitizer || kAddressSanitizer ? 50 : 300;
    const std::vector<Result> results = resultsOfAllOrders(kSteps);
    ASSERT_EQ(results.size(), 20u);
    for (std::size_t i = 1; i < results.size(); ++i) {
        ASSERT_FALSE(results[i] == results[0]) << "the order makes no difference: nothing is tested";
    }
    for (unsigned i = 0; i < kRepetitions; ++i) {
        TwoWorlds worlds;
        std::atomic<unsigned> ready{0};
        const auto run = [&ready](ChainWorld &world) {
            ++ready;
            while (ready < 2) std::this_thread::yield();
            for (unsigned step = 0; step < kSteps; ++step) world.step();
        };
        std::thread other(run, std::ref(worlds.second()));
        run(worlds.first());
        other.join();
        ASSERT_EQ(std::count(results.begin(), results.end(), worlds.result()), 1) << "repetition " << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Modes, ManyWorlds,
                         testing::Values(Mode{0, "auto"}, Mode{2, "lcp"}, Mode{5, "lcp"}, Mode{4, "auto"},
                                         Mode{4, "serial"}),
                         [](const auto &info) {
                             return info.param.algorithm + std::to_string(info.param.threads);
                         });

}  // namespace
