// Random linear complementarity problems, as those of piles, robots and chains.
#pragma once

#include <ode/odemath.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "config.h"

#include "lcp.h"

struct Shape {
    unsigned n, bilateral;
    unsigned rank;  // of A, before its diagonal gets `softness`
    double softness, decades;
    bool friction, late;  // rows with a normal's limits; rows without limits after the first ones
    unsigned reach = 0;   // columns of J that rows next to one another share, as links of a chain do; 0: all
};

// A = J J' with sparse random J, as a pile's, a robot's or a chain's.
struct Problem {
    Problem(const Shape &shape, unsigned seed)
        : random(seed), n(shape.n), skip(dPAD(n)), bilateral(shape.bilateral) {
        A.assign(std::size_t(n) * skip, std::numeric_limits<dReal>::quiet_NaN());
        makeMatrix(shape);
        for (unsigned i = 0; i < n; ++i) {
            bx.insert(bx.end(), {dReal(number() * std::pow(10, shape.decades * number())), dReal(0)});
            addLimits(shape, i);
        }
    }

    void makeMatrix(const Shape &shape) {
        std::vector<double> J(std::size_t(n) * shape.rank);
        for (unsigned i = 0; i < n; ++i)
            for (unsigned k = 0; k < 12; ++k) {
                const double value = number() * std::pow(10, shape.decades * number());
                const unsigned column = shape.reach == 0 ? random() % shape.rank
                                                         : (i * shape.rank / n + random() % shape.reach) % shape.rank;
                J[i * shape.rank + column] = value;
            }
        for (unsigned i = 0; i < n; ++i) {
            for (unsigned j = 0; j <= i; ++j) {
                double sum = 0;
                for (unsigned k = 0; k < shape.rank; ++k)
                    sum += J[i * shape.rank + k] * J[j * shape.rank + k];
                A[std::size_t(i) * skip + j] = dReal(sum);
            }
            A[std::size_t(i) * skip + i] += dReal(shape.softness);
        }
    }

    void addLimits(const Shape &shape, unsigned i) {
        const dReal endless = dInfinity, size = dReal(std::fabs(number()));
        int normal = -1;
        dReal low = -endless, high = endless;
        if (i >= shape.bilateral) {
            const unsigned kind = random() % 8;
            if (shape.friction && i > 0 && kind < 4) {
                normal = static_cast<int>(random() % i);
                low = -size, high = random() % 4 ? size : endless;
            } else if (kind == 4 && shape.late) {
            } else if (kind == 5) {
                low = -size, high = size;
            } else if (kind == 6) {
                low = -endless, high = 0;
            } else {
                low = 0, high = random() % 16 ? endless : 0;
            }
        }
        // A friction row's normal is not a friction row itself.
        if (normal >= 0 && normalOf[normal] >= 0) normal = -1;
        normalOf.push_back(normal);
        limits.insert(limits.end(), {low, high});
    }

    // The first half of the rows and the second have nothing to do with one another.
    void separateHalves() {
        for (unsigned i = n / 2; i < n; ++i) std::fill_n(&A[std::size_t(i) * skip], n / 2, dReal(0));
    }

    void removeLimits() {
        std::fill(normalOf.begin(), normalOf.end(), -1);
        for (unsigned i = 0; i < n; ++i) limits[2 * i] = -dInfinity, limits[2 * i + 1] = dInfinity;
    }

    double number() { return std::uniform_real_distribution<double>(-1, 1)(random); }

    std::mt19937 random;
    unsigned n, skip, bilateral;
    std::vector<dReal> A, bx, limits;
    std::vector<int> normalOf;
};
