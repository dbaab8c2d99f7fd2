// The rules of dxCostModel, on invented machines: no clock.
#include "dynamics/step/dxCostModel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "core/dxLog.h"

namespace {

constexpr auto kWorld = dxStepperKind::WorldExact;
constexpr auto kQuick = dxStepperKind::QuickExact;

// A machine on which islands take `scale` times their cost and sharing them out costs `overhead` ns.
struct Machine {
    double scale, overhead;
    double coldOverhead = 0;  // beside it, in the first two shared steps after one on the caller
};

// A world of equal islands, stepped again and again as dxStep does it.
class Simulation {
public:
    Simulation(Machine machine, double islandCost, unsigned islands, unsigned limit)
        : m_machine(machine), m_largest(islandCost), m_total(islandCost * islands), m_limit(limit) {}

    unsigned step() {
        const unsigned workers = m_model.chooseWorkers(kQuick, m_total, m_largest, m_limit);
        const double busy = m_total * m_machine.scale;
        double wall = busy;
        if (workers >= 2) {
            wall = std::max(busy / workers, m_largest * m_machine.scale) + m_machine.overhead;
            if (m_sharedInARow++ < 2) wall += m_machine.coldOverhead;
            m_model.learnParallel(kQuick, m_total, m_largest, workers, busy, wall);
        } else {
            m_sharedInARow = 0;
            m_model.learnSerial(kQuick, m_total, wall);
        }
        m_time += wall;
        m_serialTime += busy;
        return workers;
    }

    // Number of parallel steps.
    unsigned shared(unsigned steps) {
        unsigned count = 0;
        for (unsigned i = 0; i < steps; ++i) count += step() >= 2;
        return count;
    }

    // Time of the steps since the last call, as a part of what they take on the caller alone.
    double timeRatio() {
        const double ratio = m_time / m_serialTime;
        m_time = m_serialTime = 0;
        return ratio;
    }

    dxCostModel &model() { return m_model; }
    Machine &machine() { return m_machine; }

private:
    Machine m_machine;
    double m_largest, m_total;
    unsigned m_limit;
    unsigned m_sharedInARow = 0;
    dxCostModel m_model;
    double m_time = 0, m_serialTime = 0;
};

TEST(CostModel, CostGrowsWithEverything) {
    for (const dxStepperKind stepper : {kWorld, kQuick}) {
        for (unsigned n = 0; n < 300; ++n) {
            const double cost = dxCostModel::islandCost(stepper, 20, n, n);
            EXPECT_GT(dxCostModel::islandCost(stepper, 20, n + 1, n), cost);
            EXPECT_GT(dxCostModel::islandCost(stepper, 20, n, n + 1), cost);
        }
    }
    EXPECT_GT(dxCostModel::islandCost(kQuick, 21, 5, 5), dxCostModel::islandCost(kQuick, 20, 5, 5));
    EXPECT_EQ(dxCostModel::islandCost(kWorld, 21, 5, 5), dxCostModel::islandCost(kWorld, 20, 5, 5));
}

TEST(CostModel, CostHasTheShapeOfTheAlgorithms) {
    const auto large = [](dxStepperKind stepper, unsigned joints) {
        return dxCostModel::islandCost(stepper, 20, 0, joints);
    };
    EXPECT_NEAR(large(kWorld, 20000) / large(kWorld, 10000), 8, 0.01);
    EXPECT_DOUBLE_EQ(large(kQuick, 20000) / large(kQuick, 10000), 2);
}

TEST(CostModel, NothingCostsNothing) {
    EXPECT_EQ(dxCostModel::islandCost(kWorld, 20, 0, 0), 0);
    EXPECT_EQ(dxCostModel::islandCost(kQuick, -3, 0, 0), 0);
    EXPECT_EQ(dxCostModel::islandCost(kQuick, -3, 1, 1), dxCostModel::islandCost(kQuick, 0, 1, 1));
    // The cube of the largest number of joints is still a number.
    EXPECT_LT(dxCostModel::islandCost(kWorld, 20, ~0u, ~0u), 1e31);

    dxCostModel model;
    EXPECT_EQ(model.chooseWorkers(kWorld, 0, 0, 8), 1u);
    model.learnSerial(kWorld, 0, 1000);
    model.learnParallel(kWorld, 0, 0, 2, 0, 1e9);
    EXPECT_EQ(model.scale(kWorld), 1);
    EXPECT_GT(model.overhead(), 0);
}

TEST(CostModel, TinyWorldsStayOnTheCallerLargeOnesAreShared) {
    dxCostModel model;
    EXPECT_EQ(model.chooseWorkers(kQuick, 5e3, 1e3, 8), 1u);
    EXPECT_EQ(model.chooseWorkers(kQuick, 5e6, 1e3, 8), 8u);
}

// On a machine on which sharing out costs too much at first, and then little.
TEST(CostModel, TellsItsDecisionsAtDebugLevel) {
    const dxLogLevel before = dxGetLogLevel();
    dxSetLogLevel(dxLogLevel::Debug);
    testing::internal::CaptureStderr();
    Simulation simulation({1, 5e6}, 10e3, 100, 2);
    simulation.shared(2000);
    simulation.machine().overhead = 10e3;
    simulation.shared(20000);
    dxSetLogLevel(before);
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_NE(said.find("ODE_MT debug: cost model: a step of 1000 us on the caller costs 5000 us to share out, which does "
                        "not pay"),
              std::string::npos) << said;
    EXPECT_NE(said.find("which pays"), std::string::npos) << said;
}

TEST(CostModel, ALargerTotalNeverGetsFewerWorkers) {
    unsigned before = 0;
    for (double total = 1e3; total < 1e8; total *= 1.1) {
        const unsigned workers = dxCostModel().chooseWorkers(kQuick, total, total / 100, 64);
        EXPECT_GE(workers, before) << total;
        before = workers;
    }
    EXPECT_EQ(before, 64u);
}

TEST(CostModel, LimitIsRespected) {
    for (unsigned limit = 1; limit <= 1024; limit *= 2) {
        EXPECT_EQ(dxCostModel().chooseWorkers(kWorld, 1e12, 1, limit), limit);
    }
    EXPECT_EQ(dxCostModel().chooseWorkers(kWorld, 1e12, 1, 0), 1u);
}

TEST(CostModel, OneIslandThatIsNearlyAllIsNotShared) {
    EXPECT_EQ(dxCostModel().chooseWorkers(kWorld, 1e8, 0.95e8, 8), 1u);
    EXPECT_GE(dxCostModel().chooseWorkers(kWorld, 1e8, 0.5e8, 8), 2u);
}

TEST(CostModel, ScaleConvergesToTheMachine) {
    for (const double truth : {0.1, 1.0, 30.0}) {
        dxCostModel model;
        for (int i = 0; i < 300; ++i) model.learnSerial(kQuick, 1e5, 1e5 * truth);
        EXPECT_NEAR(model.scale(kQuick), truth, 1e-3 * truth);
        EXPECT_EQ(model.scale(kWorld), 1) << "the other stepper's";
    }
}

TEST(CostModel, OverheadAndScaleConvergeToTheMachine) {
    for (const Machine machine : {Machine{1, 5e3}, Machine{0.5, 100e3}, Machine{3, 20e3}}) {
        Simulation simulation(machine, 1e5, 40, 4);
        EXPECT_EQ(simulation.shared(300), 300u);
        EXPECT_NEAR(simulation.model().overhead(), machine.overhead, 0.01 * machine.overhead);
        EXPECT_NEAR(simulation.model().scale(kQuick), machine.scale, 0.01 * machine.scale);
    }
}

TEST(CostModel, OneStepMovesTheAveragesALittleInTheRightDirection) {
    dxCostModel model;
    model.learnSerial(kQuick, 1e5, 2e5);
    EXPECT_GT(model.scale(kQuick), 1);
    EXPECT_LT(model.scale(kQuick), 1.2);
    const double overhead = model.overhead();
    model.learnParallel(kQuick, 1e6, 1e4, 2, 1e6, 0.5e6 + 10 * overhead);
    EXPECT_GT(model.overhead(), overhead);
    EXPECT_LT(model.overhead(), 2 * overhead);
    const double higher = model.overhead();
    model.learnParallel(kQuick, 1e6, 1e4, 2, 1e6, 0.5e6);
    EXPECT_LT(model.overhead(), higher);
    EXPECT_GT(model.overhead(), 0);
}

// A world that seemed too small on the model's machine turns out to be worth sharing on a slow one.
TEST(CostModel, SlowMachineSharesSmallerWorlds) {
    Simulation fast({1, 8e3}, 1e3, 8, 2), slow({20, 8e3}, 1e3, 8, 2);
    EXPECT_EQ(fast.step(), 1u);
    EXPECT_EQ(slow.step(), 1u);
    slow.shared(200);
    EXPECT_EQ(slow.step(), 2u);
}

TEST(CostModel, AnOverheadMeasuredTooHighFadesAndIsProbedAgain) {
    Simulation simulation({1, 5e6}, 1e4, 20, 2);
    simulation.shared(200);
    EXPECT_LT(simulation.shared(200), 20u) << "it is too high";
    simulation.machine().overhead = 5e3;  // whatever disturbed it is over
    unsigned steps = 0;
    while (simulation.step() < 2 && steps < 100000) ++steps;
    EXPECT_LT(steps, 20000u);
    simulation.shared(200);
    EXPECT_EQ(simulation.shared(100), 100u);
}

// Workers that sleep take long to wake, and little from then on: what one step alone pays must not keep a world on the
// caller for which sharing pays.
TEST(CostModel, WhatOnlyTheFirstStepsPayIsFoundOut) {
    Simulation simulation({1, 5e6}, 1e4, 16, 2);  // 160 us a step
    simulation.shared(200);
    simulation.machine() = {1, 10e3, 150e3};
    unsigned steps = 0;
    while (simulation.step() < 2 && steps < 200000) ++steps;
    EXPECT_LT(steps, 100000u);
    simulation.shared(10);
    EXPECT_EQ(simulation.shared(1000), 1000u);
}

// Other programs take the processors for a moment: sharing that paid before is soon taken up again, in the end
// as soon after the hundredth time as after the first.
TEST(CostModel, ADisturbanceIsSoonForgotten) {
    const Machine calm{1, 10e3, 20e3}, disturbed{1, 3e6, 0};
    Simulation simulation(calm, 1e4, 16, 2);  // 160 us a step
    simulation.shared(500);
    for (int i = 0; i < 100; ++i) {
        simulation.machine() = disturbed;
        unsigned steps = 0;
        while (simulation.step() >= 2) ASSERT_LT(++steps, 100u);
        simulation.machine() = calm;
        EXPECT_GE(simulation.shared(1000), 800u) << i;
    }
}

TEST(CostModel, SmallerWorldsAreNoPartOfALargerOnesProbe) {
    dxCostModel model;
    for (int i = 0; i < 100; ++i) model.learnParallel(kQuick, 1e6, 1e4, 2, 1e6, 1e7);
    unsigned steps = 0;
    while (model.chooseWorkers(kQuick, 1e6, 1e4, 2) < 2 && steps < 100000) ++steps;
    ASSERT_LT(steps, 100000u);
    EXPECT_EQ(model.chooseWorkers(kQuick, 1e6, 1e4, 2), 2u);
    EXPECT_EQ(model.chooseWorkers(kQuick, 5e5, 1e4, 2), 1u);
}

// Probes cost little: a world that sharing does not serve is hardly slower for it in the long run.
TEST(CostModel, ProbesCostLittle) {
    for (const double coldOverhead : {0.0, 100e3}) {
        for (const double overhead : {60e3, 100e3, 1e6, 20e6}) {
            Simulation simulation({1, overhead, coldOverhead}, 1e4, 10, 2);  // 100 us a step
            simulation.shared(20000);
            simulation.timeRatio();
            simulation.shared(50000);
            EXPECT_LT(simulation.timeRatio(), 1.01) << "overhead " << overhead << " ns, first steps " << coldOverhead;
        }
    }
}

}  // namespace
