// The factorisation by fronts against dense matrices, with the same bits on every instruction set and for every number of threads.
//
// Covers dxFrontPlan.cpp.
#include "dynamics/world_step/fast/dxFrontFactor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "instruction_sets.h"
#include "own_threads.h"

namespace {

using Pairs = std::vector<std::pair<unsigned, unsigned>>;

// A symmetric, positive definite matrix in blocks of joints of one to six rows, and a right-hand side.
class RandomSystem {
public:
    RandomSystem(unsigned joints, const Pairs &pairs, unsigned seed) : m_random(seed) {
        order.find(joints, pairs);
        for (unsigned i = 0; i < joints; ++i) rowsOf.push_back(1 + m_random() % 6);
        for (const unsigned rows : rowsOf) firstRow.push_back(firstRow.back() + rows);
        plan.make(order, rowsOf);
        matrix.assign(firstRow.back(), std::vector<double>(firstRow.back()));
        fillBlocks(pairs);
        for (std::size_t row = 0; row < matrix.size(); ++row) {
            double sum = 1;
            for (const double element : matrix[row]) sum += std::abs(element);
            matrix[row][row] = sum;
            rightSide.push_back(number());
        }
    }

    // Of all joints x, by place.
    std::vector<double> solve(dxFrontFactor &factor, dxPhaseRunner &phases) {
        factor.shape(plan);
        factor.reserve(phases.threads());
        if (!factorise(factor, phases)) return {};
        factor.substitute(phases);
        std::vector<double> x;
        for (unsigned joint = 0; joint < rowsOf.size(); ++joint)
            x.insert(x.end(), factor.solutionOf(joint), factor.solutionOf(joint) + rowsOf[joint]);
        return x;
    }

    double residual(const std::vector<double> &x) const {
        double worst = 0;
        for (std::size_t row = 0; row < matrix.size(); ++row) {
            long double sum = -rightSide[row];
            for (std::size_t column = 0; column < matrix.size(); ++column) sum += static_cast<long double>(matrix[row][column]) * x[column];
            worst = std::max(worst, static_cast<double>(std::abs(sum)));
        }
        return worst;
    }

    dxEliminationOrder order;
    std::vector<unsigned> rowsOf, firstRow{0};
    dxFrontPlan plan;
    std::vector<std::vector<double>> matrix;
    std::vector<double> rightSide;

private:
    double number() { return std::uniform_real_distribution<double>(-1, 1)(m_random); }

    void fillBlocks(const Pairs &pairs) {
        for (const auto &[one, other] : pairs) {
            const unsigned a = order.placeOf(one), b = order.placeOf(other);
            for (unsigned row = firstRow[a]; row < firstRow[a + 1]; ++row)
                for (unsigned column = firstRow[b]; column < firstRow[b + 1]; ++column)
                    matrix[row][column] = matrix[column][row] = number();
        }
    }

    bool factorise(dxFrontFactor &factor, dxPhaseRunner &phases) {
        return factor.factorise(phases, [this](const dxFrontPlan::Front &front, const dxFrontNumbers &numbers, unsigned) {
            const auto placeOf = [&](unsigned index) {
                return index < front.end - front.begin ? front.begin + index : plan.rowJoints()[front.firstRow + index - (front.end - front.begin)];
            };
            const unsigned count = front.end - front.begin + front.endRow - front.firstRow;
            for (unsigned i = 0; front.begin + i < front.end; ++i)
                for (unsigned pivot = 0; pivot < rowsOf[front.begin + i]; ++pivot) {
                    const unsigned row = firstRow[front.begin + i] + pivot;
                    double *const column = numbers.column(plan.rowOf(front, i) + pivot);
                    for (unsigned k = i; k < count; ++k)
                        std::copy_n(&matrix[row][firstRow[placeOf(k)]], rowsOf[placeOf(k)], column + plan.rowOf(front, k));
                    column[numbers.columns()] = rightSide[row];
                }
        });
    }

    std::mt19937 m_random;
};

// Joints as nodes of a grid, of a tree, of a clique, and any.
Pairs gridPairs(unsigned side) {
    Pairs pairs;
    for (unsigned i = 0; i < side * side; ++i) {
        if ((i + 1) % side != 0) pairs.emplace_back(i, i + 1);
        if (i + side < side * side) pairs.emplace_back(i, i + side);
    }
    return pairs;
}

Pairs randomPairs(unsigned joints, unsigned count, unsigned seed) {
    std::mt19937 random(seed);
    Pairs pairs;
    for (unsigned i = 0; i < count; ++i) {
        const unsigned one = random() % joints, other = random() % joints;
        if (one != other) pairs.emplace_back(one, other);
    }
    return pairs;
}

Pairs cliquePairs(unsigned joints) {
    Pairs pairs;
    for (unsigned i = 0; i < joints; ++i)
        for (unsigned k = i + 1; k < joints; ++k) pairs.emplace_back(i, k);
    return pairs;
}

void expectSolution(unsigned joints, const Pairs &pairs, unsigned seed) {
    RandomSystem system(joints, pairs, seed);
    dxFrontFactor factor;
    dxPhaseRunner alone;
    const std::vector<double> x = system.solve(factor, alone);
    ASSERT_EQ(x.size(), system.rightSide.size());
    EXPECT_LT(system.residual(x), 1e-13) << joints << " joints, seed " << seed;
}

TEST(FrontFactor, SolvesAsADenseMatrixDoes) {
    expectSolution(1, {}, 1);
    expectSolution(5, {}, 2);  // five fronts without a parent
    for (unsigned seed = 0; seed < 10; ++seed) {
        expectSolution(9, gridPairs(3), seed);
        expectSolution(25, cliquePairs(25), seed);
        expectSolution(60, randomPairs(60, 59, seed), seed);
        expectSolution(60, randomPairs(60, 150, seed), seed);
    }
    expectSolution(400, gridPairs(20), 3);
}

TEST(FrontFactor, RefusesAMatrixThatIsNotPositiveDefinite) {
    RandomSystem system(36, gridPairs(6), 1);
    const double before = system.matrix[20][20];
    dxFrontFactor factor;
    dxPhaseRunner alone;
    for (const double wrong : {-1.0, 0.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        system.matrix[20][20] = wrong;
        EXPECT_TRUE(system.solve(factor, alone).empty()) << wrong;
    }
    system.matrix[20][20] = before;
    EXPECT_LT(system.residual(system.solve(factor, alone)), 1e-13) << "after one that it refused";
}

// Two joints with the same rows.
TEST(FrontFactor, RefusesRowsThatAreThereTwice) {
    RandomSystem system(2, {{0, 1}}, 1);
    for (std::vector<double> &row : system.matrix) std::fill(row.begin(), row.end(), 1);
    dxFrontFactor factor;
    dxPhaseRunner alone;
    EXPECT_TRUE(system.solve(factor, alone).empty());
}

TEST(FrontFactor, HasTheSameBitsOnEveryInstructionSet) {
    RandomSystem system(400, gridPairs(20), 7);
    std::vector<double> first;
    for (const std::int64_t set : instructionSets())
        onInstructionSet(set, [&] {
            dxFrontFactor factor;
            dxPhaseRunner alone;
            const std::vector<double> x = system.solve(factor, alone);
            ASSERT_EQ(x.size(), system.rightSide.size());
            if (first.empty()) first = x;
            EXPECT_EQ(std::memcmp(first.data(), x.data(), x.size() * sizeof x[0]), 0);
        });
    EXPECT_FALSE(first.empty());
}

// Chunks side by side, and fronts at the top of which columns are shared.
TEST(FrontFactor, HasTheSameBitsForEveryNumberOfThreads) {
    Pairs pairs = gridPairs(24);
    for (const auto &[one, other] : randomPairs(24 * 24, 200, 5)) pairs.emplace_back(one, other);  // a wide top
    RandomSystem system(24 * 24, pairs, 3);
    EXPECT_GT(system.plan.top().size(), 3u);
    EXPECT_GT(system.plan.chunks().size(), 3u);
    EXPECT_GT(system.plan.mostRows(), 300u);
    std::vector<double> first;
    onSeveralThreads([&](dxPhaseRunner &phases) {
        dxFrontFactor factor;
        const std::vector<double> x = system.solve(factor, phases);
        ASSERT_EQ(x.size(), system.rightSide.size());
        if (first.empty()) first = x;
        EXPECT_EQ(std::memcmp(first.data(), x.data(), x.size() * sizeof x[0]), 0);
    });
}

}  // namespace
