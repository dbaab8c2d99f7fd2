// QuickStep's sweep gives the bits of taking the rows one by one, for every instruction set of this machine.
#include "instruction_sets.h"
#include "dynamics/sweep/dxSweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace {

using Limits = std::numeric_limits<dReal>;

// An island of random rows in joints of three: one free row and two that it bounds, as in a contact.
struct RandomIsland {
    RandomIsland(unsigned joints, unsigned bodyCount, unsigned seed, bool extremes)
        : random(seed), bodies(bodyCount), jacobian(16 * 3 * joints), impulse(12 * 3 * joints), lambda(3 * joints),
          force(6 * bodyCount), order(3 * joints) {
        for (unsigned joint = 0; joint < joints; ++joint) addJoint(joint);
        for (dReal &value : lambda) value = number(extremes);
        for (dReal &value : force) value = number(extremes);
        for (dReal &value : impulse) value = number(extremes);
        std::iota(order.begin(), order.end(), 0);
    }

    void addJoint(unsigned joint) {
        const int first = static_cast<int>(random() % bodies);
        int second = static_cast<int>(random() % (bodies + 1)) - 1;  // -1: none
        if (second == first) second = -1;
        for (unsigned row = 3 * joint; row < 3 * joint + 3; ++row) {
            bodiesOfRow.insert(bodiesOfRow.end(), {first, second});
            boundingRow.push_back(row == 3 * joint ? -1 : static_cast<int>(3 * joint));
            fillRow(&jacobian[16 * row], row != 3 * joint);
            if (second == -1) std::fill_n(&jacobian[16 * row + dxSweepIsland::kBody2], 6, Limits::quiet_NaN());
        }
    }

    void fillRow(dReal *row, bool bounded) {
        for (int i = 0; i < 14; ++i) row[i] = number(false);
        row[dxSweepIsland::kLow] = bounded ? 0 : -std::fabs(number(false));
        row[dxSweepIsland::kHigh] = std::fabs(number(false));
        switch (random() % 4) {
            case 0:
                row[dxSweepIsland::kHigh] = Limits::infinity();
                break;
            case 1:
                std::swap(row[dxSweepIsland::kLow], row[dxSweepIsland::kHigh]);  // no number lies between
                break;
        }
    }

    dReal number(bool extreme) {
        if (extreme && random() % 500 == 0) {
            const dReal values[] = {Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN(), Limits::max(),
                                    Limits::denorm_min(), -dReal(0)};
            return values[random() % 6];
        }
        return std::uniform_real_distribution<dReal>(-0.4, 0.4)(random);
    }

    dxSweepIsland island() {
        return {static_cast<unsigned>(order.size()), bodies, jacobian.data(), impulse.data(), bodiesOfRow.data(),
                boundingRow.data(), lambda.data(), force.data()};
    }

    // Shuffles rows, but keeps those that bound others before them.
    void shuffle() {
        std::shuffle(order.begin(), order.end(), random);
        std::stable_partition(order.begin(), order.end(), [this](int row) { return boundingRow[row] == -1; });
    }

    std::mt19937 random;
    unsigned bodies;
    std::vector<dReal> jacobian, impulse, lambda, force;
    std::vector<int> bodiesOfRow, boundingRow, order;
};

// Successive over-relaxation as a textbook has it, with the sums in upstream's order.
void sweepOneByOne(RandomIsland &of) {
    for (const int row : of.order) {
        const dReal *J = &of.jacobian[16 * row], *change = &of.impulse[12 * row];
        dReal *force[2] = {&of.force[6 * of.bodiesOfRow[2 * row]], nullptr};
        if (of.bodiesOfRow[2 * row + 1] >= 0) force[1] = &of.force[6 * of.bodiesOfRow[2 * row + 1]];
        const dReal old = of.lambda[row];
        dReal delta = J[6] - old * J[7];
        for (int body = 0; body < 2 && force[body]; ++body) {
            dReal sum = force[body][0] * J[8 * body];
            for (int i = 1; i < 6; ++i) sum += force[body][i] * J[8 * body + i];
            delta -= sum;
        }
        dReal low = J[14], high = J[15];
        if (of.boundingRow[row] >= 0) {
            high = std::fabs(high * of.lambda[of.boundingRow[row]]);
            low = -high;
        }
        of.lambda[row] = old + delta;
        if (old + delta < low) {
            of.lambda[row] = low;
            delta = low - old;
        } else if (old + delta > high) {
            of.lambda[row] = high;
            delta = high - old;
        }
        for (int body = 0; body < 2 && force[body]; ++body) {
            for (int i = 0; i < 6; ++i) force[body][i] += delta * change[6 * body + i];
        }
    }
}

// NaN equals NaN, whatever its bits: which of two NaN a sum keeps is not upstream's to say.
bool sameNumbers(const std::vector<dReal> &a, const std::vector<dReal> &b) {
    return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](dReal x, dReal y) {
               return (std::isnan(x) && std::isnan(y)) || std::memcmp(&x, &y, sizeof x) == 0;
           });
}

bool mostlyFinite(const std::vector<dReal> &numbers) {
    const auto finite = std::count_if(numbers.begin(), numbers.end(), [](dReal x) { return std::isfinite(x); });
    return 10 * static_cast<std::size_t>(finite) > 9 * numbers.size();
}

struct Size {
    unsigned joints, bodies;
};
constexpr Size kSizes[] = {{1, 1}, {1, 2}, {5, 2}, {40, 10}, {120, 200}, {400, 60}, {700, 2000}};

class Sweep : public testing::TestWithParam<bool> {};  // with extreme numbers?

TEST_P(Sweep, IsThatOfTakingRowsOneByOne) {
    for (const std::int64_t set : instructionSets()) {
        onInstructionSet(set, [] {
            for (const Size size : kSizes) {
                RandomIsland ours(size.joints, size.bodies, 7 + size.joints, GetParam());
                RandomIsland reference(size.joints, size.bodies, 7 + size.joints, GetParam());
                for (int sweep = 0; sweep < 6; ++sweep) {
                    ours.shuffle();
                    reference.shuffle();
                    dxSweep(ours.island(), ours.order.data());
                    sweepOneByOne(reference);
                    ASSERT_TRUE(sameNumbers(ours.lambda, reference.lambda)) << size.joints << " joints";
                    ASSERT_TRUE(sameNumbers(ours.force, reference.force)) << size.joints << " joints";
                }
                if (!GetParam()) { ASSERT_TRUE(mostlyFinite(ours.force)); }
            }
        });
    }
}

TEST_P(Sweep, ByScheduleHasTheSameResult) {
    for (const Size size : kSizes) {
        RandomIsland ours(size.joints, size.bodies, 3 + size.joints, GetParam());
        RandomIsland reference(size.joints, size.bodies, 3 + size.joints, GetParam());
        const std::size_t rows = ours.order.size();
        std::vector<int> order(rows);
        std::vector<unsigned> level(rows), work(std::max<std::size_t>(rows, size.bodies));
        ours.shuffle();
        reference.shuffle();
        dxScheduleSweep(ours.island(), ours.order.data(), {order.data(), level.data(), work.data()});
        ASSERT_TRUE(std::is_permutation(order.begin(), order.end(), ours.order.begin()));
        dxSweep(ours.island(), order.data());
        sweepOneByOne(reference);
        EXPECT_TRUE(sameNumbers(ours.lambda, reference.lambda)) << size.joints << " joints";
        EXPECT_TRUE(sameNumbers(ours.force, reference.force)) << size.joints << " joints";
    }
}

INSTANTIATE_TEST_SUITE_P(Numbers, Sweep, testing::Bool(),
                         [](const auto &info) { return info.param ? "extreme" : "ordinary"; });

// Ten bodies in a row, four rows between neighbours, in the order of the joints: a schedule takes rows of
// neighbours that share no body at once.
TEST(SweepSchedule, PutsRowsOfDifferentBodiesSideBySide) {
    constexpr unsigned kBodies = 10, kRowsPerLink = 4, kRows = (kBodies - 1) * kRowsPerLink;
    std::vector<int> bodies, order(kRows), scheduled(kRows);
    for (unsigned row = 0; row < kRows; ++row) {
        // Every second link first: the others wait for them, not for one another.
        const int link = static_cast<int>(row / kRowsPerLink * 2 % (kBodies - 1));
        bodies.insert(bodies.end(), {link, link + 1});
    }
    std::iota(order.begin(), order.end(), 0);
    std::vector<unsigned> level(kRows), work(kRows);
    dxSweepIsland island{};
    island.rows = kRows;
    island.bodies = kBodies;
    island.bodiesOfRow = bodies.data();
    dxScheduleSweep(island, order.data(), {scheduled.data(), level.data(), work.data()});
    unsigned waiting = 0;
    for (unsigned i = 1; i < kRows; ++i) {
        const int *row = &bodies[2 * scheduled[i]], *before = &bodies[2 * scheduled[i - 1]];
        waiting += row[0] == before[0] || row[0] == before[1] || row[1] == before[0] || row[1] == before[1];
    }
    EXPECT_LE(waiting, 2 * kRowsPerLink);  // in the given order: 27 of 35
}

}  // namespace
