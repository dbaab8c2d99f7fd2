// Steps of "fast" where joints are hard and repeat or contradict one another: the step has an answer, the same for every number of threads, and
// what is left of the rows is as little as can be.
//
// More random worlds with ODE_MT_EXACTNESS=thorough.
#include <gtest/gtest.h>

#include <ode/ode.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "../exactness/thorough.h"
#include "../frame/OdeSession.h"
#include "hard_world.h"
#include "island_rows.h"
#include "kept_messages.h"
#include "random_world.h"
#include "robot_world.h"

#include "dynamics/world_step/fast/dxFastWorldStep.h"

namespace {

constexpr dReal kStepSize = dReal(0.01);

unsigned countOfWorlds() { return exactness::isThorough() ? 1200 : 40; }

class HardRows : public testing::Test {
protected:
    HardRows() {
        keptMessages.clear();
        dSetMessageHandler(keepMessage);
        dSetDebugHandler(keepMessageAndLeave);
    }
    ~HardRows() override {
        dSetMessageHandler(nullptr);
        dSetDebugHandler(nullptr);
    }

private:
    const OdeSession m_session;
};

using Step = int (*)(dWorldID, dReal);

// Throws if a step fails an assertion.
std::vector<dReal> stateAfterSteps(unsigned seed, const char *solver, unsigned threads, Step step) {
    constexpr unsigned kSteps = 20;
    dToggleODE_MT(static_cast<int>(threads));
    HardWorld world(seed);
    dODE_MT_SetSolver(world.world(), solver);
    for (unsigned i = 0; i <= seed % 4; ++i) world.addAtRandom();
    for (unsigned i = 0; i < kSteps; ++i) {
        world.collide();
        step(world.world(), kStepSize);
    }
    return world.state();
}

bool isFinite(const std::vector<dReal> &state) {
    return std::all_of(state.begin(), state.end(), [](dReal number) { return std::isfinite(number); });
}

void expectAnswers(Step step) {
    for (unsigned seed = 0; seed < countOfWorlds(); ++seed) {
        SCOPED_TRACE("world " + std::to_string(seed));
        const std::vector<dReal> serial = stateAfterSteps(seed, "fast", 0, step);
        EXPECT_TRUE(isFinite(serial));
        for (const unsigned threads : {2u, 5u}) EXPECT_EQ(stateAfterSteps(seed, "fast", threads, step), serial) << threads << " threads";
        EXPECT_EQ(keptMessages, "");
        keptMessages.clear();
    }
}

TEST_F(HardRows, HaveAnAnswer) { expectAnswers(&dWorldStep); }

TEST_F(HardRows, HaveAnAnswerInQuickStep) { expectAnswers(&dWorldQuickStep); }

// Else the two above would show nothing.
TEST_F(HardRows, HaveNoAnswerInManyExactSteps) {
    const auto hasAnswer = [](unsigned seed) {
        try {
            return isFinite(stateAfterSteps(seed, "exact", 0, &dWorldStep));
        } catch (const std::runtime_error &) {
            return false;
        }
    };
    unsigned failures = 0;
    for (unsigned seed = 0; seed < countOfWorlds(); ++seed) failures += !hasAnswer(seed);
    RecordProperty("failures", static_cast<int>(failures));
    EXPECT_GE(failures, countOfWorlds() / 3);
}

// --- residuals ----------------------------------------------------------------------------------------------

// J, by rows of all bodies' six directions, and b = c/h - J (v/h + inv(M) f).
struct DenseRows {
    std::vector<std::vector<double>> jacobian;
    std::vector<double> b, diagonal;
    double rounding = 0;  // of the velocities of which b is the rest

    DenseRows(const dxIslandStep &step, const dxWorldStepProblem &problem)
        : jacobian(problem.rowCount, std::vector<double>(6 * problem.bodyCount)), b(problem.rowCount), diagonal(problem.rowCount) {
        for (unsigned i = 0; i < problem.jointCount; ++i)
            for (unsigned row = 0; row < problem.joints[i].rows; ++row) addRow(step, problem, problem.joints[i], row);
    }

    // Of w = J inv(M) J' x - b.
    std::vector<double> residualOf(const dxWorldStepProblem &problem) const {
        std::vector<double> accelerations(6 * problem.bodyCount);
        for (unsigned body = 0; body < problem.bodyCount; ++body) {
            double force[6] = {};
            for (unsigned row = 0; row < problem.rowCount; ++row)
                for (unsigned k = 0; k < 6; ++k) force[k] += jacobian[row][6 * body + k] * problem.pairsBX[2 * row + 1];
            accelerate(problem, body, force, &accelerations[6 * body]);
        }
        std::vector<double> w(problem.rowCount);
        for (unsigned row = 0; row < problem.rowCount; ++row)
            w[row] = std::inner_product(accelerations.begin(), accelerations.end(), jacobian[row].begin(), -b[row]);
        return w;
    }

    double energyOf(const std::vector<double> &w) const {
        double energy = 0;
        for (std::size_t row = 0; row < w.size(); ++row)
            if (diagonal[row] > 0) energy += w[row] * w[row] / diagonal[row];
        return energy;
    }

    // The least energy that any motion of the bodies leaves: that of b, less its part in the space of the columns of J, found one after the other
    // (Gram and Schmidt, the longest one first, twice). Directions in which rows are the same up to `nearly` count as contradictions.
    double leastEnergy(double nearly) const {
        std::vector<std::vector<double>> columns;
        for (std::size_t k = 0; k < jacobian.front().size(); ++k) {
            columns.emplace_back();
            for (std::size_t row = 0; row < b.size(); ++row)
                columns.back().push_back(diagonal[row] > 0 ? jacobian[row][k] / std::sqrt(diagonal[row]) : 0);
            const double length = std::sqrt(dot(columns.back(), columns.back()));
            for (double &number : columns.back()) number /= length > 0 ? length : 1;
        }
        std::vector<double> rest(b.size());
        for (std::size_t row = 0; row < b.size(); ++row) rest[row] = diagonal[row] > 0 ? b[row] / std::sqrt(diagonal[row]) : 0;
        while (!columns.empty()) {
            const auto isShorter = [](const auto &one, const auto &other) { return dot(one, one) < dot(other, other); };
            const auto longest = std::max_element(columns.begin(), columns.end(), isShorter);
            std::vector<double> axis = *longest;
            columns.erase(longest);
            const double length = std::sqrt(dot(axis, axis));
            if (length < nearly) break;
            for (double &number : axis) number /= length;
            for (unsigned twice = 0; twice < 2; ++twice) {
                remove(axis, rest);
                for (std::vector<double> &column : columns) remove(axis, column);
            }
        }
        return dot(rest, rest);
    }

private:
    static double dot(const std::vector<double> &one, const std::vector<double> &other) {
        return std::inner_product(one.begin(), one.end(), other.begin(), 0.0);
    }

    static void remove(const std::vector<double> &axis, std::vector<double> &from) {
        const double part = dot(axis, from);
        for (std::size_t i = 0; i < from.size(); ++i) from[i] -= part * axis[i];
    }

    static void accelerate(const dxWorldStepProblem &problem, unsigned body, const double *force, double *acceleration) {
        for (unsigned axis = 0; axis < 3; ++axis) {
            acceleration[axis] = force[axis] * problem.bodies[body]->invMass;
            acceleration[3 + axis] = 0;
            for (unsigned k = 0; k < 3; ++k) acceleration[3 + axis] += double(problem.inverseInertia[body].tensor[4 * axis + k]) * force[3 + k];
        }
    }

    void addRow(const dxIslandStep &step, const dxWorldStepProblem &problem, const dxWorldStepJoint &joint, unsigned row) {
        const unsigned index = joint.firstRow + row;
        b[index] = problem.pairsBX[2 * index];
        for (unsigned side = 0; side < 2; ++side) {
            const dxBody *const body = joint.joint->node[side].body;
            if (body == nullptr) continue;
            const dReal *const elements = problem.rowsOf(joint, side) + row * dxWorldStepProblem::kElements;
            double *const to = &jacobian[index][6 * unsigned(body->tag)];
            std::copy_n(elements, 6, to);
            double motion[6];
            const double force[6] = {body->facc[0], body->facc[1], body->facc[2], body->tacc[0], body->tacc[1], body->tacc[2]};
            accelerate(problem, unsigned(body->tag), force, motion);
            double push[6];
            accelerate(problem, unsigned(body->tag), to, push);
            double sum = 0;
            for (unsigned k = 0; k < 6; ++k) {
                motion[k] += (k < 3 ? body->lvel[k] : body->avel[k - 3]) / step.stepSize;
                b[index] -= to[k] * motion[k];
                diagonal[index] += to[k] * push[k];
                sum += std::fabs(to[k] * motion[k]);
            }
            rounding = std::max(rounding, 64 * std::numeric_limits<double>::epsilon() * sum);
        }
    }
};

bool hasUnilateralRows(const dxWorldStepProblem &problem) {
    return !std::all_of(problem.pairsLoHi, problem.pairsLoHi + 2 * std::size_t(problem.rowCount), [](dReal limit) { return std::isinf(limit); });
}

// Steps the world by "fast", and calls visit(rows before, problem after) for each island.
template <class Visit>
void stepFast(dWorldID world, const Visit &visit) {
    struct Solver final : dxWorldStepSolver {
        explicit Solver(const Visit &visit) : m_visit(visit) {}
        bool solve(const dxIslandStep &step, const dxWorldStepProblem &problem) override {
            const bool isUnilateral = hasUnilateralRows(problem);
            const DenseRows rows(step, problem);
            const bool areForcesApplied = dxFastWorldStep().solve(step, problem);
            m_visit(rows, problem, isUnilateral);
            return areForcesApplied;
        }
        const Visit &m_visit;
    } solver(visit);
    forIslands(world, kStepSize, &dxEstimateFastWorldStepMemory, [&](const dxIsland &island, dxWorldProcessMemArena *arena) {
        dxWorldStep({world, kStepSize, island, arena}, solver);
    });
}

double largestOf(const std::vector<double> &numbers) {
    double largest = 0;
    for (const double number : numbers) largest = std::max(largest, std::fabs(number));
    return largest;
}

// Steps worlds of joints that are made twice or hold bodies which were moved, and calls visit as stepFast does.
template <class Visit>
void stepHardJoints(const HardWorld::Shape &shape, const Visit &visit) {
    for (unsigned seed = 0; seed < countOfWorlds(); ++seed) {
        HardWorld world(seed, shape);
        world.add(seed % 2 == 0 ? HardWorld::Scene::DoubleHinges : HardWorld::Scene::FixedJoints);
        for (unsigned i = 0; i < 3; ++i) {
            SCOPED_TRACE("world " + std::to_string(seed) + ", step " + std::to_string(i));
            stepFast(world.world(), visit);
        }
    }
}

// Joints that repeat one another have rows that forces satisfy.
TEST_F(HardRows, ThatRepeatOneAnotherAreSatisfied) {
    unsigned islands = 0;
    stepHardJoints({false, 40, false}, [&](const DenseRows &rows, const dxWorldStepProblem &problem, bool isUnilateral) {
        EXPECT_FALSE(isUnilateral);
        EXPECT_LE(largestOf(rows.residualOf(problem)), 1e-6 * largestOf(rows.b) + rows.rounding) << problem.rowCount << " rows";
        ++islands;
    });
    EXPECT_GE(islands, countOfWorlds());
}

// Where no forces satisfy all rows, little more is left than by the motion that leaves least.
TEST_F(HardRows, ThatContradictOneAnotherAreSatisfiedAsFarAsCanBe) {
    unsigned contradictory = 0;
    stepHardJoints({true, 20, false}, [&](const DenseRows &rows, const dxWorldStepProblem &problem, bool) {
        const double least = rows.leastEnergy(1e-4), all = rows.energyOf(rows.b);
        const double rounding = rows.energyOf(std::vector<double>(problem.rowCount, rows.rounding));
        EXPECT_LE(rows.energyOf(rows.residualOf(problem)), 1.1 * least + 1e-8 * all + rounding) << problem.rowCount << " rows";
        contradictory += least > 1e-6 * all;
    });
    EXPECT_GE(contradictory, countOfWorlds() / 2);
}

}  // namespace
