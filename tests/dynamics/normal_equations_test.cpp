// The normal equations solve the problem of rows, in body space; the products that they are made of agree with their definitions.
#include "dynamics/world_step/fast/dxNormalEquations.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "random_body_space_problem.h"

namespace {

// (J inv(M) J' + D) dx = q, whose residual is computed with the problem's own products.
TEST(NormalEquations, SolvesInTheSpaceOfRows) {
    for (unsigned seed = 0; seed < 10; ++seed) {
        RandomBodySpaceProblem random({40, 80, 12, 1e-8}, seed);
        const dxBodySpaceProblem &problem = random.problem;
        std::vector<double> d, q, dx, s;
        for (unsigned i = 0; i < problem.rowCount; ++i) {
            d.push_back(i % 5 == 0 ? std::numeric_limits<double>::infinity() : 0.1 + std::fabs(random.number()));
            q.push_back(random.number());
        }
        const unsigned padded = dxProblemChunks::padded(problem.rowCount);
        d.resize(padded, std::numeric_limits<double>::infinity());
        for (std::vector<double> *array : {&q, &dx, &s}) array->resize(padded);
        dxNormalEquations system;
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

// J u and J' x, of all chunks, by the definition.
TEST(NormalEquations, MultiplyByTheJacobian) {
    for (unsigned seed = 0; seed < 5; ++seed) {
        RandomBodySpaceProblem random({150, 500, 3, 1e-8}, seed);
        const dxBodySpaceProblem &problem = random.problem;
        dxProblemChunks chunks;
        chunks.make(problem);
        EXPECT_GT(chunks.rows().size(), 1u);
        EXPECT_GT(chunks.bodies().size(), 1u);
        dxBodyVectors u(problem.bodyCount), forces(problem.bodyCount);
        for (dxBodyVector &body : u)
            for (unsigned k = 0; k < kBodyAxes; ++k) body.lane[k] = random.number();
        std::vector<double> x(dxProblemChunks::padded(problem.rowCount)), products(x.size());
        for (unsigned i = 0; i < problem.rowCount; ++i) x[i] = random.number();
        for (const dxProblemChunks::Rows &rows : chunks.rows()) dxRowProducts::multiply(problem, rows, u, products.data());
        for (const dxProblemChunks::Bodies &bodies : chunks.bodies())
            dxRowProducts::multiplyTransposed(problem, chunks, bodies, x.data(), forces);
        std::vector<long double> expected(std::size_t(problem.bodyCount) * kBodyAxes);
        for (const dxManifold &manifold : problem.manifolds)
            for (unsigned row = manifold.firstRow; row < manifold.endRow; ++row) {
                long double sum = 0;
                for (unsigned side = 0; side < 2; ++side)
                    for (unsigned k = 0; k < kBodyAxes && manifold.body[side] != dxManifold::kNoBody; ++k) {
                        const double element = problem.jacobian[2 * row + side].lane[k];
                        sum += (long double)element * u[manifold.body[side]].lane[k];
                        expected[std::size_t(manifold.body[side]) * kBodyAxes + k] += (long double)element * x[row];
                    }
                EXPECT_NEAR(products[row], double(sum), 1e-13);
            }
        for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(forces[i / kBodyAxes].lane[i % kBodyAxes], double(expected[i]), 1e-12);
    }
}

}  // namespace
