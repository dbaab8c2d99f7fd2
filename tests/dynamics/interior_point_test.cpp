// The interior-point method on random problems with limits of every kind: it reaches a residual of rounding, also where rows are hard,
// repeat or contradict one another, with the same bits on every instruction set.
#include "dynamics/world_step/fast/dxInteriorPoint.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "dynamics/world_step/fast/dxResidual.h"
#include "instruction_sets.h"
#include "random_body_space_problem.h"

namespace {

double solve(dxInteriorPoint &interior, const RandomBodySpaceProblem &random) {
    dxPhaseRunner alone;
    interior.begin(random.problem, random.order, alone, 1);
    interior.low() = random.problem.lo;
    interior.high() = random.problem.hi;
    return interior.solve();
}

// By the definition, without the solver's products.
double residualOf(const RandomBodySpaceProblem &random, const std::vector<double> &x) {
    const dxBodySpaceProblem &problem = random.problem;
    std::vector<long double> u(std::size_t(problem.bodyCount) * kBodyAxes);
    const auto forEachElement = [&](const auto &visit) {
        for (const dxManifold &manifold : problem.manifolds)
            for (unsigned row = manifold.firstRow; row < manifold.endRow; ++row)
                for (unsigned side = 0; side < 2; ++side)
                    for (unsigned k = 0; k < kBodyAxes && manifold.body[side] != dxManifold::kNoBody; ++k)
                        visit(row, manifold.body[side], k, problem.jacobian[2 * row + side].lane[k]);
    };
    forEachElement([&](unsigned row, unsigned body, unsigned k, long double element) {
        u[body * kBodyAxes + k] += element * x[row] * problem.inverseMass[body].column[k].lane[k];
    });
    std::vector<long double> w(problem.rowCount);
    for (unsigned i = 0; i < problem.rowCount; ++i) w[i] = (long double)problem.c[i] * x[i] - problem.b[i];
    forEachElement([&](unsigned row, unsigned body, unsigned k, long double element) { w[row] += element * u[body * kBodyAxes + k]; });
    double worst = 0;
    for (unsigned i = 0; i < problem.rowCount; ++i) {
        EXPECT_GE(x[i], problem.lo[i]);
        EXPECT_LE(x[i], problem.hi[i]);
        worst = std::max(worst, dxKktResidual(x[i], double(w[i]), problem.lo[i], problem.hi[i]));
    }
    return worst;
}

// To what rounding leaves.
void expectSolved(const RandomBodySpaceProblem::Shape &shape, unsigned seed) {
    SCOPED_TRACE(std::to_string(shape.bodies) + " bodies, seed " + std::to_string(seed));
    RandomBodySpaceProblem random(shape, seed);
    dxInteriorPoint interior;
    const double residual = solve(interior, random);
    const dxInteriorPoint::Scale scale = interior.scaleOf(interior.x());
    const double tolerance = 1e-11 * scale.b + 1e-14 * scale.sum;
    EXPECT_LE(residual, tolerance);
    EXPECT_LE(residualOf(random, interior.x()), tolerance);
    EXPECT_LT(interior.factorisations(), 80u);
}

TEST(InteriorPoint, SolvesRandomProblems) {
    for (const double softness : {1e-3, 1e-6, 1e-9})
        for (const RandomBodySpaceProblem::Shape shape : {RandomBodySpaceProblem::Shape{1, 0, 3, softness},
                                                          {2, 1, 6, softness},
                                                          {7, 10, 4, softness},
                                                          {40, 80, 3, softness},
                                                          {40, 60, 12, softness}})
            for (unsigned seed = 0; seed < 20; ++seed) expectSolved(shape, seed);
}

TEST(InteriorPoint, SolvesRowsThatRepeatOneAnother) {
    for (const double softness : {1e-3, 1e-6, 1e-9})
        for (unsigned seed = 0; seed < 20; ++seed) expectSolved({20, 30, 2, softness, true}, seed);
}

TEST(InteriorPoint, HasTheSameBitsOnEveryInstructionSet) {
    const RandomBodySpaceProblem random({40, 60, 12, 1e-8}, 5);
    std::vector<double> first;
    for (const std::int64_t set : instructionSets())
        onInstructionSet(set, [&] {
            dxInteriorPoint interior;
            solve(interior, random);
            if (first.empty()) first = interior.x();
            EXPECT_EQ(std::memcmp(first.data(), interior.x().data(), first.size() * sizeof(double)), 0);
        });
    EXPECT_FALSE(first.empty());
}

}  // namespace
