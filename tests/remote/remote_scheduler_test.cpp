// Which problem goes to which worker, and what happens to it: without a transport, and without threads.
#include "remote/coordinator/dxRemoteScheduler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

namespace {

using State = dxRemoteProblem::State;

class RemoteScheduler : public testing::Test {
protected:
    RemoteScheduler() {
        std::vector<dxRemoteWorker> workers(2);
        m_scheduler.begin(workers);
        for (dxRemoteWorker &one : m_scheduler.workers()) {
            one.link.welcome();
            one.link.setMeasured(1e3, 0.1);
            one.link.noteAwake(m_scheduler.now());
        }
        m_scheduler.noteAvailable();
    }

    // A step with problems of these costs, all of them queued.
    void enqueue(const std::vector<double> &costs) {
        m_step.all.resize(costs.size());
        m_step.returned.reserve(costs.size());
        m_step.reclaimed.reserve(2 * costs.size());
        m_scheduler.add(m_step);
        std::list<dxRemoteProblem *> nodes(costs.size());
        for (std::size_t i = 0; i < costs.size(); ++i) {
            m_step.all[i].cost = costs[i];
            m_step.all[i].state = State::Queued;
            m_step.all[i].bytes = dxRemoteBytes(8, std::byte(i));
            m_scheduler.enqueue(m_step.all[i], nodes);
        }
    }

    // Of the next message; none: there is none.
    std::vector<unsigned> takeMessage() {
        m_sending = {};
        if (!m_scheduler.takeMessage(m_sending)) return {};
        std::vector<unsigned> indices;
        for (const std::uint64_t number : m_sending.problems) indices.push_back(dxRemoteIndexOf(number));
        return indices;
    }

    static dxRemoteBytes resultsOf(const dxRemoteSending &sending) {
        dxRemoteFrame frame;
        for (const std::uint64_t number : sending.problems) frame.addItem(number, "result", 6);
        return frame.seal(dxRemoteKind::Results, sending.number);
    }

    std::size_t countOf(State state) const {
        return static_cast<std::size_t>(
            std::count_if(m_step.all.begin(), m_step.all.end(), [state](const dxRemoteProblem &one) { return one.state == state; }));
    }

    dxRemoteScheduler m_scheduler;
    dxRemoteProblems m_step;
    dxRemoteSending m_sending;
};

TEST_F(RemoteScheduler, TheMostExpensiveProblemsGoFirstToTheFreestWorker) {
    enqueue({1e6, 4e6, 2e6, 3e6, 0.5e6});
    std::vector<unsigned> workers;
    for (const unsigned expected : {1u, 3u, 2u, 0u}) {
        EXPECT_EQ(takeMessage(), std::vector<unsigned>{expected});
        workers.push_back(m_sending.worker);
    }
    EXPECT_NE(workers[0], workers[1]);
    EXPECT_NE(workers[2], workers[3]);
    EXPECT_TRUE(takeMessage().empty()) << "each worker has one that it solves, and one that waits";
    EXPECT_EQ(m_step.all[4].state, State::Queued);
    EXPECT_EQ(m_scheduler.counts().sent, 4u);
}

TEST_F(RemoteScheduler, SmallProblemsShareAMessage) {
    enqueue(std::vector<double>(40, 10e3));
    EXPECT_EQ(takeMessage().size(), 10u) << "of a fourth of what is queued";
    EXPECT_EQ(takeMessage().size(), 7u);
}

TEST_F(RemoteScheduler, ResultsAreTheSteps) {
    enqueue({1e6, 2e6});
    ASSERT_EQ(takeMessage(), std::vector<unsigned>{1});
    m_scheduler.accept(m_sending.worker, resultsOf(m_sending));
    EXPECT_EQ(m_step.returned, std::vector<unsigned>{1});
    EXPECT_EQ(m_step.all[1].state, State::Returned);
    EXPECT_EQ(std::memcmp(m_step.all[1].bytes.data(), "result", 6), 0);
    EXPECT_TRUE(m_step.reclaimed.empty());
}

TEST_F(RemoteScheduler, ResultsOfOtherProblemsDropTheWorker) {
    enqueue({1e6, 2e6});
    takeMessage();
    dxRemoteSending other = m_sending;
    other.problems[0] = dxRemoteNumber(m_step.number, 0);
    m_scheduler.accept(m_sending.worker, resultsOf(other));
    EXPECT_TRUE(m_scheduler.workers()[m_sending.worker].isLost());
    EXPECT_EQ(m_step.reclaimed, std::vector<unsigned>{1});
    EXPECT_EQ(m_step.all[1].outcome, dxRemoteOutcome::Lost);
    EXPECT_EQ(m_scheduler.counts().open, 1u);
    EXPECT_TRUE(m_scheduler.hasLost());
}

TEST_F(RemoteScheduler, AMessageWithoutResultsGivesItsProblemsBack) {
    enqueue({1e6});
    takeMessage();
    m_sending.problems.clear();
    m_scheduler.accept(m_sending.worker, resultsOf(m_sending));
    EXPECT_EQ(m_step.all[0].outcome, dxRemoteOutcome::NoResult);
    EXPECT_EQ(m_step.reclaimed, std::vector<unsigned>{0});
    EXPECT_FALSE(m_scheduler.hasLost());
}

TEST_F(RemoteScheduler, WithoutWorkersTheQueueIsReclaimed) {
    enqueue(std::vector<double>(6, 1e6));
    takeMessage();
    m_scheduler.dropWorker(0, "is a test");
    EXPECT_TRUE(m_scheduler.areThere());
    EXPECT_EQ(countOf(State::Queued), 5u);
    m_scheduler.dropAll("a test");
    EXPECT_FALSE(m_scheduler.areThere());
    EXPECT_EQ(countOf(State::Reclaimed), 6u);
    EXPECT_FALSE(m_scheduler.hasQueued());
    EXPECT_EQ(m_scheduler.counts().lost, 2u);
    EXPECT_EQ(m_scheduler.capacity().workers, 0u);
}

TEST_F(RemoteScheduler, ProblemsThatAreExpectedSoonStayWithTheirWorker) {
    enqueue({1e6});
    takeMessage();
    EXPECT_FALSE(m_scheduler.withdrawLast(m_step));
    EXPECT_FALSE(m_scheduler.hasWithdrawals());
}

TEST_F(RemoteScheduler, ProblemsThatThisProcessSolvesSoonerAreReclaimed) {
    for (dxRemoteWorker &one : m_scheduler.workers()) one.link.setMeasured(50e6, 0.1);
    enqueue({1e6});
    takeMessage();
    EXPECT_TRUE(m_scheduler.withdrawLast(m_step));
    EXPECT_TRUE(m_scheduler.hasWithdrawals());
    EXPECT_EQ(m_step.all[0].outcome, dxRemoteOutcome::Sooner);
    EXPECT_EQ(m_step.reclaimed, std::vector<unsigned>{0});
    EXPECT_FALSE(m_scheduler.withdrawLast(m_step)) << "once";
}

TEST_F(RemoteScheduler, TheCheapestUnsentProblemIsTaken) {
    enqueue({5e6, 1e6, 3e6});
    EXPECT_EQ(m_scheduler.takeUnsent(m_step), &m_step.all[1]);
    EXPECT_EQ(m_scheduler.takeUnsent(m_step), &m_step.all[2]);
    EXPECT_EQ(m_scheduler.takeUnsent(m_step), &m_step.all[0]);
    EXPECT_EQ(m_scheduler.takeUnsent(m_step), nullptr);
}

TEST_F(RemoteScheduler, AMessageThatCannotBeMadeIsReclaimed) {
    enqueue({1e6, 2e6});
    takeMessage();
    m_scheduler.takeMessageBack(m_sending);
    EXPECT_EQ(m_step.reclaimed, std::vector<unsigned>{1});
    EXPECT_EQ(takeMessage(), std::vector<unsigned>{0}) << "the worker has nothing more to do than before";
}

TEST_F(RemoteScheduler, AStepThatHasEndedIsForgotten) {
    enqueue({1e6, 2e6});
    takeMessage();
    m_scheduler.remove(m_step);
    EXPECT_FALSE(m_scheduler.hasQueued());
    m_scheduler.accept(m_sending.worker, resultsOf(m_sending));
    EXPECT_FALSE(m_scheduler.hasLost());
    EXPECT_TRUE(m_step.returned.empty());
}

TEST(LinkMeasurement, TheFastestOfEachSizeCounts) {
    dxLinkMeasurement measurement;
    using Echo = dxLinkMeasurement::Echo;
    const double took[] = {90, 50, 70, 60, 9000, 8000, 8500};
    for (unsigned i = 0; i < 7; ++i) {
        EXPECT_EQ(measurement.number(), i);
        EXPECT_EQ(measurement.size() > 0, i >= 4);
        measurement.begin(1000);
        EXPECT_EQ(measurement.end(i + 1, 2000), Echo::Unexpected);
        EXPECT_EQ(measurement.end(i, 1000 + took[i]), i < 6 ? Echo::Next : Echo::Last);
    }
    EXPECT_EQ(measurement.latencyNs(), 50);
    EXPECT_DOUBLE_EQ(measurement.nsPerByte(), (8000 - 50) / (2.0 * 262144));
}

TEST(RestartPause, DoublesUntilAWorkerHasProvedItself) {
    dxRestartPause pause;
    double length = 100e6;
    for (int i = 0; i < 5; ++i, length *= 2) {
        pause.begin(0, false);
        EXPECT_FALSE(pause.isOver(length - 1));
        EXPECT_TRUE(pause.isOver(length));
    }
    for (int i = 0; i < 20; ++i) pause.begin(0, false);
    EXPECT_TRUE(pause.isOver(60e9));
    pause.begin(0, true);
    EXPECT_TRUE(pause.isOver(100e6));
}

}  // namespace
