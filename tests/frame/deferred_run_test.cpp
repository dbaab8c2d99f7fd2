// Units that are run out of order leave what a loop over them would have: reports and notifications in order, random numbers of their own, up to
// the first unit that was interrupted.
#include "dynamics/step/dxDeferredRun.h"

#include <gtest/gtest.h>
#include <ode/ode.h>

#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

std::vector<std::string> *heard = nullptr;

void hear(int number, const char *format, va_list arguments) {
    char text[100];
    std::vsnprintf(text, sizeof text, format, arguments);
    heard->push_back(std::to_string(number) + " " + text);
}

class DeferredRun : public testing::Test {
protected:
    DeferredRun() { dInitODE2(0); }
    ~DeferredRun() override {
        dSetMessageHandler(nullptr);
        dCloseODE();
    }

    // What the user hears in commit(), notifications as "moved UNIT".
    std::vector<std::string> commit(unsigned end) {
        std::vector<std::string> events;
        heard = &events;
        dSetMessageHandler(hear);
        m_run.commit(end, [&events](unsigned unit) { events.push_back("moved " + std::to_string(unit)); });
        dSetMessageHandler(nullptr);
        return events;
    }

    dxDeferredRun m_run;
};

using Events = std::vector<std::string>;

TEST_F(DeferredRun, ReportsComeInTheOrderOfUnits) {
    m_run.begin(3, 2, false);
    for (const unsigned unit : {2u, 0u, 1u})
        m_run.run(unit, unit % 2, [unit] {
            dMessage(static_cast<int>(unit), "first");
            dMessage(static_cast<int>(unit), "second");
        });
    EXPECT_EQ(m_run.interrupted(), 3u);
    EXPECT_EQ(commit(3), (Events{"0 first", "0 second", "moved 0", "1 first", "1 second", "moved 1", "2 first", "2 second", "moved 2"}));
}

TEST_F(DeferredRun, PartsOfAUnitOnTwoWorkersReportInTheirOrder) {
    m_run.begin(2, 3, false);
    m_run.run(1, 2, [] { dMessage(1, "first"); });
    m_run.run(1, 0, [] { dMessage(1, "second"); });
    EXPECT_EQ(commit(2), (Events{"moved 0", "1 first", "1 second", "moved 1"}));
}

// There the loop goes on, at the first unit that was interrupted, whichever was interrupted first.
TEST_F(DeferredRun, AMessageForAHandlerInterruptsTheUnit) {
    m_run.begin(5, 2, true);
    for (const unsigned unit : {4u, 2u, 3u, 0u}) {
        bool isOver = false;
        m_run.run(unit, 1, [&] {
            if (unit != 0) dMessage(9, "not heard");
            isOver = true;
        });
        EXPECT_EQ(isOver, unit == 0);
    }
    EXPECT_EQ(m_run.interrupted(), 2u);
    EXPECT_TRUE(m_run.isNeeded(1));
    EXPECT_TRUE(m_run.isNeeded(2));
    EXPECT_FALSE(m_run.isNeeded(3));
    EXPECT_EQ(commit(2), (Events{"moved 0", "moved 1"}));
}

TEST_F(DeferredRun, AnErrorIsTheLastReport) {
    m_run.begin(3, 1, false);
    m_run.run(2, 0, [] { dMessage(2, "not delivered"); });
    m_run.run(1, 0, [] {
        dMessage(1, "before");
        dError(1, "the end");
    });
    EXPECT_EQ(m_run.interrupted(), 1u);
    EXPECT_EXIT(m_run.commit(1, [](unsigned) {}), testing::ExitedWithCode(1), "before(.|\n)*the end");
}

TEST_F(DeferredRun, UnitsDrawWhatALoopWouldHaveDrawn) {
    constexpr unsigned kUnits = 4;
    const auto drawsOf = [](unsigned unit) { return std::uint64_t{3} * unit; };
    dRandSetSeed(5);
    std::uint32_t seed = 5;
    m_run.begin(kUnits, 1, false);
    m_run.reserve(kUnits, drawsOf);
    for (unsigned unit = 0; unit < kUnits; ++unit) {
        EXPECT_EQ(m_run.seedOf(unit), seed) << unit;
        m_run.run(unit, 0, [&] {
            EXPECT_EQ(dxUpstreamScope::current()->takeBlock(2), seed);
            EXPECT_EQ(dxUpstreamScope::current()->takeBlock(1), dxRandom::jump(seed, 2));
        });
        seed = dxRandom::jump(seed, drawsOf(unit));
    }
    EXPECT_EQ(m_run.randomEnd(), seed);
    EXPECT_EQ(dRandGetSeed(), seed);
}

// Structures may overlap by a part, and a third one may join two that do not.
TEST_F(DeferredRun, FeedbackThatTwoUnitsWriteIsFound) {
    const dWorldID world = dWorldCreate();
    const dBodyID body = dBodyCreate(world);
    dJointFeedback structures[8];
    const auto at = [&structures](std::size_t bytes) { return reinterpret_cast<dJointFeedback *>(reinterpret_cast<char *>(structures) + bytes); };
    constexpr std::size_t kSize = sizeof(dJointFeedback);
    const auto collect = [&](unsigned unit, std::size_t bytes) {
        const dJointID joint = dJointCreateBall(world, nullptr);
        dJointAttach(joint, body, nullptr);
        dJointSetFeedback(joint, at(bytes));
        m_run.collectFeedback({&body, &joint, 1, 1}, unit, unit % 2);
    };
    const auto find = [&] {
        std::vector<unsigned> units;
        m_run.forSharedFeedback([&units](unsigned unit) { units.push_back(unit); });
        return units;
    };
    m_run.begin(6, 2, false);
    collect(0, 0);
    collect(0, kSize / 2);
    collect(1, 4 * kSize);
    EXPECT_EQ(find(), std::vector<unsigned>{});
    collect(5, 2 * kSize);
    collect(3, 2 * kSize);
    EXPECT_EQ(find(), std::vector<unsigned>{3});
    collect(4, kSize + kSize / 4);
    EXPECT_EQ(find(), std::vector<unsigned>{0});
    m_run.begin(6, 2, false);
    EXPECT_EQ(find(), std::vector<unsigned>{});
    dWorldDestroy(world);
}

TEST_F(DeferredRun, BeginsAnew) {
    m_run.begin(2, 2, true);
    m_run.run(1, 1, [] { dMessage(1, "not heard"); });
    m_run.addBusy(1, 7);
    EXPECT_EQ(m_run.busyNs(), 7);
    m_run.begin(2, 1, false);
    EXPECT_EQ(m_run.busyNs(), 0);
    EXPECT_EQ(m_run.interrupted(), 2u);
    EXPECT_EQ(commit(2), (Events{"moved 0", "moved 1"}));
}

}  // namespace
