// The factorisation in body space against dense matrices, with the same bits on every instruction set and for every number of threads.
#include "dynamics/world_step/fast/dxBlockFactor.h"

#include <gtest/gtest.h>

#include <cstring>

#include "dynamics/world_step/fast/dxNormalEquations.h"
#include "instruction_sets.h"
#include "own_threads.h"
#include "random_body_space_problem.h"

namespace {

using Dense = std::vector<std::vector<long double>>;

// M + J' W J
Dense denseMatrix(const dxBodySpaceProblem &problem, const std::vector<double> &weight) {
    const std::size_t n = std::size_t(problem.bodyCount) * kBodyAxes;
    Dense matrix(n, std::vector<long double>(n));
    for (std::size_t i = 0; i < n; ++i)
        for (unsigned k = 0; k < kBodyAxes; ++k)
            matrix[i][i / kBodyAxes * kBodyAxes + k] = problem.mass[i / kBodyAxes].column[k].lane[i % kBodyAxes];
    for (const dxManifold &manifold : problem.manifolds)
        for (unsigned row = manifold.firstRow; row < manifold.endRow; ++row) {
            std::vector<long double> dense(n);
            for (unsigned side = 0; side < 2; ++side)
                for (unsigned k = 0; k < kBodyAxes && manifold.body[side] != dxManifold::kNoBody; ++k)
                    dense[std::size_t(manifold.body[side]) * kBodyAxes + k] = problem.jacobian[2 * row + side].lane[k];
            for (std::size_t i = 0; i < n; ++i)
                for (std::size_t j = 0; j < n && dense[i] != 0; ++j) matrix[i][j] += weight[row] * dense[i] * dense[j];
        }
    return matrix;
}

dxBodyVectors randomVector(RandomBodySpaceProblem &random) {
    dxBodyVectors vector(random.problem.bodyCount);
    for (dxBodyVector &body : vector) {
        body = {};
        for (unsigned k = 0; k < kBodyAxes; ++k) body.lane[k] = random.number();
    }
    return vector;
}

std::vector<double> randomWeights(RandomBodySpaceProblem &random) {
    std::vector<double> weight;
    for (unsigned i = 0; i < random.problem.rowCount; ++i)
        weight.push_back(random.random() % 3 == 0 ? 0 : std::pow(10, 4 * random.number()));
    return weight;
}

const RandomBodySpaceProblem::Shape kShapes[] = {{1, 0, 3, 1e-8}, {2, 1, 6, 1e-8}, {7, 10, 12, 1e-8}, {40, 80, 12, 1e-8}, {150, 500, 3, 1e-8}};

bool factorise(const RandomBodySpaceProblem &random, const std::vector<double> &weight, dxBlockFactor &factor, dxPhaseRunner &phases) {
    dxProblemChunks chunks;
    chunks.make(random.problem);
    factor.shape(random.order, phases.threads());
    return factor.factorise(phases, [&](unsigned begin, unsigned end) {
        dxRowProducts::makeColumns(random.problem, chunks, random.order, begin, end, weight.data(), factor);
    });
}

// H y = r for a y that is known.
void expectSolution(const RandomBodySpaceProblem::Shape &shape, unsigned seed) {
    RandomBodySpaceProblem random(shape, seed);
    const std::vector<double> weight = randomWeights(random);
    dxBlockFactor factor;
    dxPhaseRunner alone;
    ASSERT_TRUE(factorise(random, weight, factor, alone));
    const dxBodyVectors expected = randomVector(random);
    const Dense matrix = denseMatrix(random.problem, weight);
    dxBodyVectors y(expected.size());
    for (std::size_t i = 0; i < matrix.size(); ++i) {
        long double sum = 0;
        for (std::size_t j = 0; j < matrix.size(); ++j) sum += matrix[i][j] * expected[j / kBodyAxes].lane[j % kBodyAxes];
        y[i / kBodyAxes].lane[i % kBodyAxes] = static_cast<double>(sum);
    }
    factor.solve(alone, y);
    for (std::size_t i = 0; i < matrix.size(); ++i)
        EXPECT_NEAR(y[i / kBodyAxes].lane[i % kBodyAxes], expected[i / kBodyAxes].lane[i % kBodyAxes], 1e-7);
    for (const dxBodyVector &body : y)
        for (unsigned k = kBodyAxes; k < kBodyLanes; ++k) EXPECT_EQ(body.lane[k], 0);
}

TEST(BlockFactor, SolvesAsADenseMatrixDoes) {
    for (const RandomBodySpaceProblem::Shape &shape : kShapes)
        for (unsigned seed = 0; seed < 10; ++seed) expectSolution(shape, seed);
}

TEST(BlockFactor, RefusesAMatrixThatIsNotPositiveDefinite) {
    RandomBodySpaceProblem random(kShapes[2], 1);
    dxBlockFactor factor;
    dxPhaseRunner alone;
    for (const double mass : {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        random.problem.mass[3].column[2].lane[2] = mass;
        EXPECT_FALSE(factorise(random, std::vector<double>(random.problem.rowCount), factor, alone));
    }
}

TEST(BlockFactor, HasTheSameBitsOnEveryInstructionSet) {
    RandomBodySpaceProblem random(kShapes[3], 7);
    const std::vector<double> weight = randomWeights(random);
    const dxBodyVectors right = randomVector(random);
    dxBodyVectors first;
    for (const std::int64_t set : instructionSets())
        onInstructionSet(set, [&] {
            dxBlockFactor factor;
            dxPhaseRunner alone;
            ASSERT_TRUE(factorise(random, weight, factor, alone));
            dxBodyVectors y = right;
            factor.solve(alone, y);
            if (first.empty()) first = y;
            EXPECT_EQ(std::memcmp(first.data(), y.data(), y.size() * sizeof y[0]), 0);
        });
    EXPECT_FALSE(first.empty());
}

// A factorisation with a top: its columns are shared, and so are the chunks of columns below it.
TEST(BlockFactor, HasTheSameBitsForEveryNumberOfThreads) {
    RandomBodySpaceProblem random({300, 900, 3, 1e-8}, 3);
    const std::vector<double> weight = randomWeights(random);
    const dxBodyVectors right = randomVector(random);
    dxFactorPlan plan;
    plan.make(random.order);
    EXPECT_GT(plan.top().size(), 10u);
    EXPECT_GT(plan.chunks().size(), 3u);
    dxBodyVectors first;
    onSeveralThreads([&](dxPhaseRunner &phases) {
        dxBlockFactor factor;
        ASSERT_TRUE(factorise(random, weight, factor, phases));
        dxBodyVectors y = right;
        factor.solve(phases, y);
        if (first.empty()) first = y;
        EXPECT_EQ(std::memcmp(first.data(), y.data(), y.size() * sizeof y[0]), 0);
    });
}

}  // namespace
