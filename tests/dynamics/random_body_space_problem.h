// Random problems in body space: bodies in a chain, a grid or anyhow, with rows between neighbours and to the world.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "dynamics/world_step/fast/dxBodySpaceProblem.h"
#include "dynamics/world_step/fast/dxEliminationOrder.h"

struct RandomBodySpaceProblem {
    struct Shape {
        unsigned bodies, manifolds, rows;  // rows of each manifold
        double softness;                   // c, as part of the diagonal
        bool areRepeated = false;          // each row twice
    };

    RandomBodySpaceProblem(const Shape &shape, unsigned seed) : random(seed) {
        std::vector<std::pair<unsigned, unsigned>> pairs;
        for (unsigned i = 0; i < shape.manifolds; ++i) {
            const unsigned a = random() % shape.bodies, b = (a + 1 + random() % std::min(4u, shape.bodies)) % shape.bodies;
            if (a != b) pairs.emplace_back(a, b);
        }
        order.find(shape.bodies, pairs);
        problem.bodyCount = shape.bodies;
        for (unsigned i = 0; i < shape.bodies; ++i) addBody();
        std::sort(pairs.begin(), pairs.end());
        pairs.erase(std::unique(pairs.begin(), pairs.end(),
                                [](const auto &a, const auto &b) {
                                    return std::minmax(a.first, a.second) == std::minmax(b.first, b.second);
                                }),
                    pairs.end());
        for (const auto &[a, b] : pairs) addManifold(shape, order.placeOf(a), order.placeOf(b));
        addManifold(shape, 0, dxManifold::kNoBody);
        addManifold(shape, dxManifold::kNoBody, dxManifold::kNoBody);
        problem.rowCount = static_cast<unsigned>(problem.b.size());
    }

    double number() { return std::uniform_real_distribution<double>(-1, 1)(random); }

    std::mt19937 random;
    dxBodySpaceProblem problem;
    dxEliminationOrder order;

private:
    void addBody() {
        dxBodyBlock mass = {}, inverse = {};
        const double kilograms = 1 + 0.9 * number();
        for (unsigned k = 0; k < kBodyAxes; ++k) {
            const double value = k < 3 ? kilograms : kilograms * (0.2 + 0.1 * number());
            mass.column[k].lane[k] = value;
            inverse.column[k].lane[k] = 1 / value;
        }
        problem.mass.push_back(mass);
        problem.inverseMass.push_back(inverse);
    }

    void addManifold(const Shape &shape, unsigned a, unsigned b) {
        const unsigned first = std::min(a, b), second = std::max(a, b);
        const auto firstRow = static_cast<unsigned>(problem.b.size());
        const unsigned block = second != dxManifold::kNoBody ? order.findBlock(second, first) : 0;
        for (unsigned i = 0; i < shape.rows; ++i) {
            addRow(shape, first, second);
            if (shape.areRepeated) repeatRow();
        }
        problem.manifolds.push_back({firstRow, static_cast<unsigned>(problem.b.size()), {first, second}, block});
    }

    void addRow(const Shape &shape, unsigned first, unsigned second) {
        double diagonal = 0;
        for (const unsigned body : {first, second}) {
            dxBodyVector side = {};
            for (unsigned k = 0; k < kBodyAxes && body != dxManifold::kNoBody; ++k) {
                side.lane[k] = number();
                diagonal += side.lane[k] * side.lane[k] * problem.inverseMass[body].column[k].lane[k];
            }
            problem.jacobian.push_back(side);
        }
        const double infinity = std::numeric_limits<double>::infinity();
        const std::pair<double, double> limits[] = {{-infinity, infinity}, {0, infinity}, {0, infinity}, {-infinity, 0},
                                                    {-0.3, 0.2},           {0, 0},        {-1e-3, 1e-3}};
        const auto [low, high] = limits[random() % std::size(limits)];
        problem.b.push_back(10 * number());
        problem.c.push_back(shape.softness * (diagonal > 0 ? diagonal : 1));
        problem.lo.push_back(low);
        problem.hi.push_back(high);
        problem.normalOf.push_back(dxBodySpaceProblem::kNoNormal);
        problem.diagonal.push_back(diagonal);
    }

    void repeatRow() {
        for (int i = 0; i < 2; ++i) problem.jacobian.push_back(*(problem.jacobian.end() - 2));
        for (std::vector<double> *array : {&problem.b, &problem.c, &problem.lo, &problem.hi, &problem.diagonal})
            array->push_back(array->back());
        problem.normalOf.push_back(dxBodySpaceProblem::kNoNormal);
    }
};
