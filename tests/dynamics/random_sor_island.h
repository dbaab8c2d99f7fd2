// Random islands for QuickStep's sweep, and the sweep as a textbook has it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include "dynamics/step/islands/dxIslandProblem.h"

// An island of random rows in joints of three: one free row and two that it bounds, as in a contact.
struct RandomIsland {
    RandomIsland(unsigned joints, unsigned bodyCount, unsigned seed, bool extremes)
        : random(seed), rows(3 * joints), bodies(bodyCount), accelerations(bodyCount), order(3 * joints),
          scheduled(3 * joints) {
        for (unsigned joint = 0; joint < joints; ++joint) addJoint(joint);
        for (dxConstraintRow &row : rows) {
            row.lambda = number(extremes);
            for (dReal &value : row.impulseOn1) value = number(extremes);
            for (dReal &value : row.impulseOn2) value = number(extremes);
        }
        for (dxSpatialMotion &of : accelerations)
            for (dReal &value : of.columns) value = number(extremes);
        std::iota(order.begin(), order.end(), 0);
    }

    void addJoint(unsigned joint) {
        const int first = static_cast<int>(random() % bodies.size());
        int second = static_cast<int>(random() % (bodies.size() + 1)) - 1;  // -1: none
        if (second == first) second = -1;
        for (unsigned i = 3 * joint; i < 3 * joint + 3; ++i) {
            dxConstraintRow &row = rows[i];
            row.body[0] = first;
            row.body[1] = second;
            row.boundingRow = i == 3 * joint ? -1 : static_cast<int>(3 * joint);
            fillColumns(row.jacobian, i != 3 * joint);
            if (second == -1) std::fill_n(row.jacobian + dxConstraintRow::kBody2, 6, std::numeric_limits<dReal>::quiet_NaN());
        }
    }

    void fillColumns(dReal *columns, bool bounded) {
        for (int i = 0; i < 14; ++i) columns[i] = number(false);
        columns[dxConstraintRow::kLow] = bounded ? 0 : -std::fabs(number(false));
        columns[dxConstraintRow::kHigh] = std::fabs(number(false));
        switch (random() % 4) {
            case 0:
                columns[dxConstraintRow::kHigh] = std::numeric_limits<dReal>::infinity();
                break;
            case 1:
                std::swap(columns[dxConstraintRow::kLow], columns[dxConstraintRow::kHigh]);  // no number lies between
                break;
        }
    }

    dReal number(bool extreme) {
        if (extreme && random() % 500 == 0) {
            using Limits = std::numeric_limits<dReal>;
            const dReal values[] = {Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN(), Limits::max(),
                                    Limits::denorm_min(), -dReal(0)};
            return values[random() % 6];
        }
        return std::uniform_real_distribution<dReal>(-0.4, 0.4)(random);
    }

    dxIslandProblem problem() {
        return {static_cast<unsigned>(rows.size()), static_cast<unsigned>(bodies.size()), rows.data(), bodies.data(),
                accelerations.data(), scheduled.data()};
    }

    // Shuffles rows, but keeps those with a friction index behind the others.
    void shuffle() {
        std::shuffle(order.begin(), order.end(), random);
        putFrictionLast();
    }
    void putFrictionLast() {
        std::stable_partition(order.begin(), order.end(), [this](int row) { return !rows[std::size_t(row)].hasFrictionIndex(); });
    }

    std::vector<dReal> lambdas() const {
        std::vector<dReal> all;
        for (const dxConstraintRow &row : rows) all.push_back(row.lambda);
        return all;
    }

    std::vector<dReal> columns() const {
        std::vector<dReal> all;
        for (const dxSpatialMotion &of : accelerations) all.insert(all.end(), of.columns, of.columns + 6);
        return all;
    }

    std::mt19937 random;
    std::vector<dxConstraintRow> rows;
    std::vector<dxIslandBody> bodies;
    std::vector<dxSpatialMotion> accelerations;
    std::vector<int> order, scheduled;
};

// Successive over-relaxation as a textbook has it, with the sums in upstream's order.
inline void sweepOneByOne(RandomIsland &of) {
    for (const int index : of.order) {
        dxConstraintRow &row = of.rows[index];
        const dReal *J = row.jacobian;
        dReal *acceleration[2] = {of.accelerations[std::size_t(row.body[0])].columns, nullptr};
        if (row.body[1] >= 0) acceleration[1] = of.accelerations[std::size_t(row.body[1])].columns;
        const dReal old = row.lambda;
        dReal delta = J[6] - old * J[7];
        for (int body = 0; body < 2 && acceleration[body]; ++body) {
            dReal sum = acceleration[body][0] * J[8 * body];
            for (int i = 1; i < 6; ++i) sum += acceleration[body][i] * J[8 * body + i];
            delta -= sum;
        }
        dReal low = J[14], high = J[15];
        if (row.boundingRow >= 0) {
            high = std::fabs(high * of.rows[row.boundingRow].lambda);
            low = -high;
        }
        row.lambda = old + delta;
        if (old + delta < low) {
            row.lambda = low;
            delta = low - old;
        } else if (old + delta > high) {
            row.lambda = high;
            delta = high - old;
        }
        for (int body = 0; body < 2 && acceleration[body]; ++body) {
            const dReal *const impulse = body == 0 ? row.impulseOn1 : row.impulseOn2;
            for (int i = 0; i < 6; ++i) acceleration[body][i] += delta * impulse[i];
        }
    }
}

// NaN equals NaN, whatever its bits: which of two NaN a sum keeps is not upstream's to say.
inline bool sameNumbers(const std::vector<dReal> &a, const std::vector<dReal> &b) {
    return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](dReal x, dReal y) {
               return (std::isnan(x) && std::isnan(y)) || std::memcmp(&x, &y, sizeof x) == 0;
           });
}

inline bool sameState(const RandomIsland &a, const RandomIsland &b) {
    return sameNumbers(a.lambdas(), b.lambdas()) && sameNumbers(a.columns(), b.columns());
}

inline bool mostlyFinite(const std::vector<dReal> &numbers) {
    const auto finite = std::count_if(numbers.begin(), numbers.end(), [](dReal x) { return std::isfinite(x); });
    return 10 * static_cast<std::size_t>(finite) > 9 * numbers.size();
}

struct Size {
    unsigned joints, bodies;
};
constexpr Size kSizes[] = {{1, 1}, {1, 2}, {5, 2}, {40, 10}, {120, 200}, {400, 60}, {700, 2000}};
