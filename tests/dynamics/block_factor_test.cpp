// The factorisation in body space against dense matrices, and the products that it is made of; with the same bits on every
// instruction set.
#include "dynamics/world_step/fast/dxBlockFactor.h"

#include <gtest/gtest.h>

#include <cstring>

#include "dynamics/world_step/fast/dxReducedSystem.h"
#include "dynamics/world_step/fast/dxRowProducts.h"
#include "instruction_sets.h"
#include "own_threads.h"
#include "random_direct_problem.h"

namespace {

using Dense = std::vector<std::vector<long double>>;

// M + J' W J
Dense denseMatrix(const dxDirectProblem &problem, const std::vector<double> &weight) {
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

dxBodyVectors randomVector(RandomDirectProblem &random) {
    dxBodyVectors vector(random.problem.bodyCount);
    for (dxBodyVector &body : vector) {
        body = {};
        for (unsigned k = 0; k < kBodyAxes; ++k) body.lane[k] = random.number();
    }
    return vector;
}

std::vector<double> randomWeights(RandomDirectProblem &random) {
    std::vector<double> weight;
    for (unsigned i = 0; i < random.problem.rowCount; ++i)
        weight.push_back(random.random() % 3 == 0 ? 0 : std::pow(10, 4 * random.number()));
    return weight;
}

const RandomDirectProblem::Shape kShapes[] = {{1, 0, 3, 1e-8}, {2, 1, 6, 1e-8}, {7, 10, 12, 1e-8}, {40, 80, 12, 1e-8}, {150, 500, 3, 1e-8}};

bool factorise(const RandomDirectProblem &random, const std::vector<double> &weight, dxBlockFactor &factor, dxPhaseRunner &phases) {
    dxProblemChunks chunks;
    chunks.make(random.problem);
    factor.shape(random.order, phases.threads());
    return factor.factorise(phases, [&](unsigned begin, unsigned end) {
        dxRowProducts::makeColumns(random.problem, chunks, random.order, begin, end, weight.data(), factor);
    });
}

// H y = r for a y that is known.
void expectSolution(const RandomDirectProblem::Shape &shape, unsigned seed) {
    RandomDirectProblem random(shape, seed);
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
    for (const RandomDirectProblem::Shape &shape : kShapes)
        for (unsigned seed = 0; seed < 10; ++seed) expectSolution(shape, seed);
}

TEST(BlockFactor, RefusesAMatrixThatIsNotPositiveDefinite) {
    RandomDirectProblem random(kShapes[2], 1);
    dxBlockFactor factor;
    dxPhaseRunner alone;
    for (const double mass : {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        random.problem.mass[3].column[2].lane[2] = mass;
        EXPECT_FALSE(factorise(random, std::vector<double>(random.problem.rowCount), factor, alone));
    }
}

// (J inv(M) J' + D) dx = q, whose residual is computed with the problem's own products.
TEST(ReducedSystem, SolvesInTheSpaceOfRows) {
    for (unsigned seed = 0; seed < 10; ++seed) {
        RandomDirectProblem random(kShapes[3], seed);
        const dxDirectProblem &problem = random.problem;
        std::vector<double> d, q, dx, s;
        for (unsigned i = 0; i < problem.rowCount; ++i) {
            d.push_back(i % 5 == 0 ? std::numeric_limits<double>::infinity() : 0.1 + std::fabs(random.number()));
            q.push_back(random.number());
        }
        const unsigned padded = dxProblemChunks::padded(problem.rowCount);
        d.resize(padded, std::numeric_limits<double>::infinity());
        for (std::vector<double> *array : {&q, &dx, &s}) array->resize(padded);
        dxReducedSystem system;
        dxPhaseRunner alone;
        system.begin(problem, random.order, alone, 1);
        ASSERT_TRUE(system.factorise(d));
        system.solve(q, dx);
        system.findResidual(dx, s);  // b - (J inv(M) J' + c) dx
        for (unsigned i = 0; i < problem.rowCount; ++i) {
            if (i % 5 == 0) {
                EXPECT_EQ(dx[i], 0);
                continue;
            }
            const double product = problem.b[i] - s[i] - problem.c[i] * dx[i];
            EXPECT_NEAR(product + d[i] * dx[i], q[i], 1e-11);
        }
    }
}

TEST(BlockFactor, HasTheSameBitsOnEveryInstructionSet) {
    RandomDirectProblem random(kShapes[3], 7);
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
    RandomDirectProblem random({300, 900, 3, 1e-8}, 3);
    const std::vector<double> weight = randomWeights(random);
    const dxBodyVectors right = randomVector(random);
    dxFactorPlan plan;
    plan.make(random.order);
    EXPECT_GT(plan.top().size(), 10u);
    EXPECT_GT(plan.chunks().size(), 3u);
    dxBodyVectors first;
    for (const unsigned threads : {1u, 2u, 3u, 5u, 8u, 16u}) {
        dxBlockFactor factor;
        dxPhaseRunner phases;
        phases.reserve(threads);
        OwnThreads runner(threads);
        phases.run(dxParallelStage::Count, runner, [&] {
            ASSERT_TRUE(factorise(random, weight, factor, phases));
            dxBodyVectors y = right;
            factor.solve(phases, y);
            if (first.empty()) first = y;
            EXPECT_EQ(std::memcmp(first.data(), y.data(), y.size() * sizeof y[0]), 0) << threads << " threads";
        });
    }
}

}  // namespace
