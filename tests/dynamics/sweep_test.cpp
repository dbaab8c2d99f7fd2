// QuickStep's sweep gives the bits of taking the rows one by one, for every instruction set of this machine.
#include "instruction_sets.h"
#include "dynamics/sweep/dxSharedSweep.h"
#include "dynamics/sweep/dxSweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <thread>
#include <tuple>
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

// The same rows, packed.
struct PackedIsland {
    explicit PackedIsland(RandomIsland &from) : of(from), rows(from.order.size()) {
        for (std::size_t i = 0; i < rows.size(); ++i) {
            std::copy_n(&of.impulse[12 * i], 12, rows[i].impulse);
            rows[i].lambda = of.lambda[i];
            std::copy_n(&of.bodiesOfRow[2 * i], 2, rows[i].body);
            rows[i].boundingRow = of.boundingRow[i];
        }
    }

    // Without the arrays that packed rows stand for.
    dxSweepIsland island() {
        dxSweepIsland island = of.island();
        island.impulse = nullptr;
        island.boundingRow = nullptr;
        island.lambda = nullptr;
        island.packed = rows.data();
        return island;
    }

    void unpack() {
        for (std::size_t i = 0; i < rows.size(); ++i) of.lambda[i] = rows[i].lambda;
    }

    RandomIsland &of;
    std::vector<dxSweepRow> rows;
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

TEST_P(Sweep, OfPackedRowsHasTheSameResult) {
    for (const std::int64_t set : instructionSets()) {
        onInstructionSet(set, [] {
            for (const Size size : kSizes) {
                RandomIsland ours(size.joints, size.bodies, 11 + size.joints, GetParam());
                RandomIsland reference(size.joints, size.bodies, 11 + size.joints, GetParam());
                PackedIsland packed(ours);
                for (int sweep = 0; sweep < 3; ++sweep) {
                    ours.shuffle();
                    reference.shuffle();
                    dxSweep(packed.island(), ours.order.data());
                    sweepOneByOne(reference);
                }
                packed.unpack();
                ASSERT_TRUE(sameNumbers(ours.lambda, reference.lambda)) << size.joints << " joints";
                ASSERT_TRUE(sameNumbers(ours.force, reference.force)) << size.joints << " joints";
            }
        });
    }
}

// A thread for each block, or the calling thread for all of them.
class Threads final : public dxTaskRunner {
public:
    explicit Threads(bool several) : m_several(several) {}

    unsigned workers() const override { return 16; }
    void run(dxParallelStage stage, unsigned blocks, dxThreadManager::Task task, void *context) override {
        if (!m_several) return dxTaskRunner::alone().run(stage, blocks, task, context);
        std::vector<std::thread> threads;
        for (unsigned block = 1; block < blocks; ++block) threads.emplace_back(task, context, block, block);
        task(context, 0, 0);
        for (std::thread &thread : threads) thread.join();
    }

private:
    bool m_several;
};

// By parts, and by whether each has a thread of its own.
class SharedSweep : public testing::TestWithParam<std::tuple<unsigned, bool>> {
protected:
    static void expectSame(Size size, dReal (*coordinate)(std::size_t body, int axis)) {
        const auto [parts, several] = GetParam();
        RandomIsland ours(size.joints, size.bodies, 5 + size.joints, true);
        RandomIsland reference(size.joints, size.bodies, 5 + size.joints, true);
        PackedIsland packed(ours);
        Threads threads(several);
        dxSharedSweep sweep;
        dReal place[3];
        sweep.begin(packed.island(), parts, [&](std::size_t body) {
            for (int axis = 0; axis < 3; ++axis) place[axis] = coordinate(body, axis);
            return place;
        });
        for (const unsigned times : {8u, 1u, 4u}) {
            ours.shuffle();
            reference.shuffle();
            sweep.sweep(packed.island(), ours.order.data(), times, threads);
            for (unsigned i = 0; i < times; ++i) sweepOneByOne(reference);
        }
        packed.unpack();
        EXPECT_TRUE(sameNumbers(ours.lambda, reference.lambda)) << size.joints << " joints";
        EXPECT_TRUE(sameNumbers(ours.force, reference.force)) << size.joints << " joints";
    }
};

TEST_P(SharedSweep, OfBodiesThatAreCutAnywhereIsThatOfOneThread) {
    for (const Size size : kSizes)
        expectSame(size, [](std::size_t body, int axis) { return dReal(body * 7 % (11 + std::size_t(axis))); });
}

TEST_P(SharedSweep, OfBodiesThatCannotBeCutIsThatOfOneThread) {
    for (const Size size : kSizes) expectSame(size, [](std::size_t, int) { return dReal(1); });
}

TEST_P(SharedSweep, OfBodiesAtPlacesThatAreNoneIsThatOfOneThread) {
    for (const Size size : kSizes)
        expectSame(size, [](std::size_t body, int axis) {
            const dReal places[] = {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(), Limits::max(), dReal(body)};
            return places[(body + std::size_t(axis)) % 5];
        });
}

INSTANTIATE_TEST_SUITE_P(Parts, SharedSweep, testing::Combine(testing::Values(1u, 2u, 3u, 7u, 16u), testing::Bool()),
                         [](const auto &info) {
                             return std::to_string(std::get<0>(info.param)) +
                                    (std::get<1>(info.param) ? "_threads" : "_parts_of_one_thread");
                         });

// Bodies along a line, each a row heavier than the one before it: the parts lie apart and weigh the same.
TEST(BodyCut, PartsLieApartAndWeighTheSame) {
    constexpr unsigned kBodies = 1000, kParts = 5;
    std::vector<dxPlace> places;
    std::vector<unsigned> weights;
    unsigned all = 0;
    for (unsigned body = 0; body < kBodies; ++body) {
        const unsigned along = body * 7 % kBodies;  // in any order
        places.push_back({{1, dReal(along), dReal(along % 3)}});
        weights.push_back(along);
        all += along;
    }
    dxBodyCut cut;
    cut.cut(places, weights, kParts);
    std::vector<unsigned> weightOf(kParts);
    std::vector<dReal> low(kParts, kBodies), high(kParts, -1);
    for (unsigned body = 0; body < kBodies; ++body) {
        const std::size_t part = cut.partOf(body);
        weightOf[part] += weights[body];
        low[part] = std::min(low[part], places[body].at[1]);
        high[part] = std::max(high[part], places[body].at[1]);
    }
    for (unsigned part = 0; part < kParts; ++part) {
        EXPECT_NEAR(weightOf[part], all / kParts, all / kParts / 10) << part;
        if (part > 0) { EXPECT_LT(high[part - 1], low[part]); }
    }
}

}  // namespace
