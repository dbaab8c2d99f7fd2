// QuickStep's sweep gives the bits of taking the rows one by one, for every instruction set of this machine.
#include "instruction_sets.h"
#include "dynamics/quick_step/sor/dxParallelSor.h"
#include "dynamics/quick_step/sor/dxSorSweep.h"

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
            if (second == -1) std::fill_n(row.jacobian + dxConstraintRow::kBody2, 6, Limits::quiet_NaN());
        }
    }

    void fillColumns(dReal *columns, bool bounded) {
        for (int i = 0; i < 14; ++i) columns[i] = number(false);
        columns[dxConstraintRow::kLow] = bounded ? 0 : -std::fabs(number(false));
        columns[dxConstraintRow::kHigh] = std::fabs(number(false));
        switch (random() % 4) {
            case 0:
                columns[dxConstraintRow::kHigh] = Limits::infinity();
                break;
            case 1:
                std::swap(columns[dxConstraintRow::kLow], columns[dxConstraintRow::kHigh]);  // no number lies between
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

    dxIslandProblem problem() {
        return {static_cast<unsigned>(rows.size()), static_cast<unsigned>(bodies.size()), rows.data(), bodies.data(),
                accelerations.data(), scheduled.data()};
    }

    // Shuffles rows, but keeps those that bound others before them.
    void shuffle() {
        std::shuffle(order.begin(), order.end(), random);
        putUnboundedFirst();
    }
    void putUnboundedFirst() {
        std::stable_partition(order.begin(), order.end(), [this](int row) { return !rows[std::size_t(row)].isBounded(); });
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
void sweepOneByOne(RandomIsland &of) {
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
bool sameNumbers(const std::vector<dReal> &a, const std::vector<dReal> &b) {
    return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](dReal x, dReal y) {
               return (std::isnan(x) && std::isnan(y)) || std::memcmp(&x, &y, sizeof x) == 0;
           });
}

bool sameState(const RandomIsland &a, const RandomIsland &b) {
    return sameNumbers(a.lambdas(), b.lambdas()) && sameNumbers(a.columns(), b.columns());
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
                    dxSorSweep(ours.problem(), ours.order.data());
                    sweepOneByOne(reference);
                    ASSERT_TRUE(sameState(ours, reference)) << size.joints << " joints";
                }
                if (!GetParam()) { ASSERT_TRUE(mostlyFinite(ours.columns())); }
            }
        });
    }
}

TEST_P(Sweep, ByScheduleHasTheSameResult) {
    for (const Size size : kSizes) {
        RandomIsland ours(size.joints, size.bodies, 3 + size.joints, GetParam());
        RandomIsland reference(size.joints, size.bodies, 3 + size.joints, GetParam());
        reference.putUnboundedFirst();
        dxScheduleSor(ours.problem());
        ASSERT_TRUE(std::is_permutation(ours.scheduled.begin(), ours.scheduled.end(), reference.order.begin()));
        dxSorSweep(ours.problem(), ours.scheduled.data());
        sweepOneByOne(reference);
        EXPECT_TRUE(sameState(ours, reference)) << size.joints << " joints";
    }
}

INSTANTIATE_TEST_SUITE_P(Numbers, Sweep, testing::Bool(),
                         [](const auto &info) { return info.param ? "extreme" : "ordinary"; });

// Ten bodies in a row, four rows between neighbours, in the order of the joints: a schedule takes rows of
// neighbours that share no body at once.
TEST(SorSchedule, PutsRowsOfDifferentBodiesSideBySide) {
    constexpr unsigned kBodies = 10, kRowsPerLink = 4, kRows = (kBodies - 1) * kRowsPerLink;
    std::vector<dxConstraintRow> rows(kRows);
    std::vector<dxSpatialMotion> accelerations(kBodies);
    std::vector<int> scheduled(kRows);
    for (unsigned row = 0; row < kRows; ++row) {
        // Every second link first: the others wait for them, not for one another.
        const int link = static_cast<int>(row / kRowsPerLink * 2 % (kBodies - 1));
        rows[row].body[0] = link;
        rows[row].body[1] = link + 1;
        rows[row].boundingRow = dxConstraintRow::kNone;
    }
    dxScheduleSor({kRows, kBodies, rows.data(), nullptr, accelerations.data(), scheduled.data()});
    unsigned waiting = 0;
    for (unsigned i = 1; i < kRows; ++i) {
        const int *row = rows[scheduled[i]].body, *before = rows[scheduled[i - 1]].body;
        waiting += row[0] == before[0] || row[0] == before[1] || row[1] == before[0] || row[1] == before[1];
    }
    EXPECT_LE(waiting, 2 * kRowsPerLink);  // in the given order: 27 of 35
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
class ParallelSor : public testing::TestWithParam<std::tuple<unsigned, bool>> {
protected:
    static void expectSame(Size size, dReal (*coordinate)(std::size_t body, int axis)) {
        const auto [parts, several] = GetParam();
        RandomIsland ours(size.joints, size.bodies, 5 + size.joints, true);
        RandomIsland reference(size.joints, size.bodies, 5 + size.joints, true);
        Threads threads(several);
        dxParallelSor sweep;
        dReal place[3];
        sweep.begin(ours.problem(), parts, [&](std::size_t body) {
            for (int axis = 0; axis < 3; ++axis) place[axis] = coordinate(body, axis);
            return place;
        });
        for (const unsigned times : {8u, 1u, 4u}) {
            ours.shuffle();
            reference.shuffle();
            sweep.sweep(ours.problem(), ours.order.data(), times, threads);
            for (unsigned i = 0; i < times; ++i) sweepOneByOne(reference);
        }
        EXPECT_TRUE(sameState(ours, reference)) << size.joints << " joints";
    }
};

TEST_P(ParallelSor, OfBodiesThatAreCutAnywhereIsThatOfOneThread) {
    for (const Size size : kSizes)
        expectSame(size, [](std::size_t body, int axis) { return dReal(body * 7 % (11 + std::size_t(axis))); });
}

TEST_P(ParallelSor, OfBodiesThatCannotBeCutIsThatOfOneThread) {
    for (const Size size : kSizes) expectSame(size, [](std::size_t, int) { return dReal(1); });
}

TEST_P(ParallelSor, OfBodiesAtPlacesThatAreNoneIsThatOfOneThread) {
    for (const Size size : kSizes)
        expectSame(size, [](std::size_t body, int axis) {
            const dReal places[] = {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(), Limits::max(), dReal(body)};
            return places[(body + std::size_t(axis)) % 5];
        });
}

INSTANTIATE_TEST_SUITE_P(Parts, ParallelSor, testing::Combine(testing::Values(1u, 2u, 3u, 7u, 16u), testing::Bool()),
                         [](const auto &info) {
                             return std::to_string(std::get<0>(info.param)) +
                                    (std::get<1>(info.param) ? "_threads" : "_parts_of_one_thread");
                         });

// Bodies along a line, each a row heavier than the one before it: the parts lie apart and weigh the same.
TEST(BodyPartition, PartsLieApartAndWeighTheSame) {
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
    dxBodyPartition partition;
    partition.partition(places, weights, kParts);
    std::vector<unsigned> weightOf(kParts);
    std::vector<dReal> low(kParts, kBodies), high(kParts, -1);
    for (unsigned body = 0; body < kBodies; ++body) {
        const std::size_t part = partition.partitionOf(body);
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
