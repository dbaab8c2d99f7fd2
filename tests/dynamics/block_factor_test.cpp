// The factorisation in body space against dense matrices, and the products that it is made of; with the same bits on every
// instruction set.
#include "dynamics/direct/dxBlockFactor.h"

#include <gtest/gtest.h>

#include <cstring>

#include "dynamics/direct/dxReducedSystem.h"
#include "dynamics/direct/dxRowProducts.h"
#include "instruction_sets.h"
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

const RandomDirectProblem::Shape kShapes[] = {{1, 0, 3, 1e-8}, {2, 1, 6, 1e-8}, {7, 10, 12, 1e-8}, {40, 80, 12, 1e-8}};

// H y = r for a y that is known.
void expectSolution(const RandomDirectProblem::Shape &shape, unsigned seed) {
    RandomDirectProblem random(shape, seed);
    const std::vector<double> weight = randomWeights(random);
    dxBlockFactor factor;
    factor.shape(random.order);
    dxRowProducts::makeMatrix(random.problem, weight, factor);
    ASSERT_TRUE(factor.factorise());
    const dxBodyVectors expected = randomVector(random);
    const Dense matrix = denseMatrix(random.problem, weight);
    dxBodyVectors y(expected.size());
    for (std::size_t i = 0; i < matrix.size(); ++i) {
        long double sum = 0;
        for (std::size_t j = 0; j < matrix.size(); ++j) sum += matrix[i][j] * expected[j / kBodyAxes].lane[j % kBodyAxes];
        y[i / kBodyAxes].lane[i % kBodyAxes] = static_cast<double>(sum);
    }
    factor.solve(y);
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
    factor.shape(random.order);
    for (const double mass : {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        random.problem.mass[3].column[2].lane[2] = mass;
        dxRowProducts::makeMatrix(random.problem, std::vector<double>(random.problem.rowCount), factor);
        EXPECT_FALSE(factor.factorise());
    }
}

// (J inv(M) J' + D) dx = q, whose residual is computed with the problem's own products.
TEST(ReducedSystem, SolvesInTheSpaceOfRows) {
    for (unsigned seed = 0; seed < 10; ++seed) {
        RandomDirectProblem random(kShapes[3], seed);
        const dxDirectProblem &problem = random.problem;
        std::vector<double> d, q, dx(problem.rowCount), s(problem.rowCount);
        for (unsigned i = 0; i < problem.rowCount; ++i) {
            d.push_back(i % 5 == 0 ? std::numeric_limits<double>::infinity() : 0.1 + std::fabs(random.number()));
            q.push_back(random.number());
        }
        dxReducedSystem system;
        system.begin(problem, random.order);
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
            factor.shape(random.order);
            dxRowProducts::makeMatrix(random.problem, weight, factor);
            ASSERT_TRUE(factor.factorise());
            dxBodyVectors y = right;
            factor.solve(y);
            if (first.empty()) first = y;
            EXPECT_EQ(std::memcmp(first.data(), y.data(), y.size() * sizeof y[0]), 0);
        });
    EXPECT_FALSE(first.empty());
}

}  // namespace
