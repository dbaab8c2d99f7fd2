// What limits QuickStep's sweep on this machine (docs/notes/2026-11-step-limits.md). Two limits hold for any sweep with upstream's bits:
//
//   chain        rows that share a body come one after the other, each with the latency of a row (chain/…)
//   throughput   no row takes less than one that waits for nothing (independent/…)
//
// For the orders of islands the counter `chain` is the length of the longest chain of rows that wait for one another, as a share of
// the rows. So a sweep takes no less than the larger of chain x (chain/…) and (independent/…) a row.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <random>
#include <vector>

#include "dynamics/quick_step/sor/dxSorOrder.h"
#include "dynamics/quick_step/sor/dxSorSweep.h"
#include "dynamics/step/islands/dxIslandProblem.h"

namespace {

using Row = dxConstraintRow;

constexpr int kContactsOfAFace = 4;
constexpr int kBoxesOfAStack = 10;
constexpr unsigned kLargeRows = 30000;  // 7.5 MiB
constexpr unsigned kSmallRows = 120;

// Contacts of bodies with mass 1, prepared as dxSorSolver does it.
class Island {
public:
    explicit Island(unsigned bodyCount) : m_bodies(bodyCount), m_accelerations(bodyCount) {}

    // A row that is not negative, and two of friction that it bounds. `second`: may be Row::kNone.
    void addContact(int first, int second) {
        const auto normal = static_cast<int>(m_rows.size());
        addRow(first, second, Row::kNone, 0, dInfinity);
        addRow(first, second, normal, 0, 0.5);
        addRow(first, second, normal, 0, 0.5);
    }

    void addFace(int first, int second) {
        for (int i = 0; i < kContactsOfAFace; ++i) addContact(first, second);
    }

    dxIslandProblem problem() {
        m_order.resize(m_rows.size());
        return {static_cast<unsigned>(m_rows.size()), static_cast<unsigned>(m_bodies.size()), m_rows.data(), m_bodies.data(),
                m_accelerations.data(), m_order.data()};
    }

private:
    void addRow(int first, int second, int bound, dReal low, dReal high) {
        Row row{};
        dReal diagonal = 0;
        for (int k = 0; k < (second == Row::kNone ? 6 : 12); ++k) {
            const dReal element = m_number(m_random);
            row.jacobian[k < 6 ? Row::kBody1 + k : Row::kBody2 + k - 6] = element;
            (k < 6 ? row.impulseOn1 : row.impulseOn2)[k % 6] = element;
            diagonal += element * element;
        }
        for (int k = 0; k < 6; ++k) {
            row.jacobian[Row::kBody1 + k] *= kRelaxation / diagonal;
            row.jacobian[Row::kBody2 + k] *= kRelaxation / diagonal;
        }
        row.jacobian[Row::kRhs] = m_number(m_random);
        row.jacobian[Row::kCfm] = dReal(1e-5);
        row.jacobian[Row::kLow] = low;
        row.jacobian[Row::kHigh] = high;
        row.body[0] = first;
        row.body[1] = second;
        row.boundingRow = bound;
        m_rows.push_back(row);
    }

    static constexpr dReal kRelaxation = dReal(1.3);

    std::mt19937 m_random{1};
    std::uniform_real_distribution<dReal> m_number{-1, 1};
    std::vector<Row> m_rows;
    std::vector<dxIslandBody> m_bodies;
    std::vector<dxSpatialMotion> m_accelerations;
    std::vector<int> m_order;
};

Island stack() {
    Island island(kBoxesOfAStack);
    island.addFace(0, Row::kNone);
    for (int box = 1; box < kBoxesOfAStack; ++box) island.addFace(box, box - 1);
    return island;
}

// Boxes on a cubic lattice, each on the one below it and beside two others.
Island pile(int side) {
    Island island(static_cast<unsigned>(side * side * side));
    const auto box = [side](int x, int y, int z) { return (z * side + y) * side + x; };
    for (int z = 0; z < side; ++z)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                island.addFace(box(x, y, z), z > 0 ? box(x, y, z - 1) : Row::kNone);
                if (x > 0) island.addFace(box(x, y, z), box(x - 1, y, z));
                if (y > 0) island.addFace(box(x, y, z), box(x, y - 1, z));
            }
    return island;
}

Island chain(unsigned rows) {
    Island island(2);
    for (unsigned i = 0; i < rows / 3; ++i) island.addContact(0, 1);
    return island;
}

// Rows of contacts that share no body with those near them in the order.
Island independent(unsigned rows) {
    Island island(rows);
    for (unsigned i = 0; i < rows / 3; ++i) island.addContact(static_cast<int>(2 * i), static_cast<int>(2 * i + 1));
    return island;
}

unsigned longestChain(const dxIslandProblem &problem) {
    std::vector<unsigned> lengths(problem.bodyCount);
    unsigned longest = 0;
    for (unsigned i = 0; i < problem.rowCount; ++i) {
        const Row &row = problem.rows[problem.order[i]];
        unsigned length = lengths[static_cast<std::size_t>(row.body[0])];
        if (row.hasSecondBody()) length = std::max(length, lengths[static_cast<std::size_t>(row.body[1])]);
        ++length;
        lengths[static_cast<std::size_t>(row.body[0])] = length;
        if (row.hasSecondBody()) lengths[static_cast<std::size_t>(row.body[1])] = length;
        longest = std::max(longest, length);
    }
    return longest;
}

enum class Order { Joints, Scheduled, Shuffled, Strided };

void makeOrder(const dxIslandProblem &problem, Order order) {
    std::iota(problem.order, problem.order + problem.rowCount, 0);
    std::mt19937 random(7);
    if (order == Order::Scheduled) dxScheduleSor(problem);
    if (order == Order::Shuffled) std::shuffle(problem.order, problem.order + problem.rowCount, random);
    // All first rows of contacts, then all second ones: neighbours share no body where contacts do not.
    if (order == Order::Strided)
        for (unsigned i = 0; i < problem.rowCount; ++i)
            problem.order[i] = static_cast<int>(3 * (i % (problem.rowCount / 3)) + i / (problem.rowCount / 3));
}

void sweep(benchmark::State &state, Island island, Order order) {
    const dxIslandProblem problem = island.problem();
    makeOrder(problem, order);
    for (auto _ : state) dxSorSweep(problem, problem.order, problem.isLarge());
    state.counters["ns/row"] =
        benchmark::Counter(static_cast<double>(problem.rowCount) * 1e-9, benchmark::Counter::kIsIterationInvariantRate |
                                                                              benchmark::Counter::kInvert);
    state.counters["chain"] = static_cast<double>(longestChain(problem)) / problem.rowCount;
}

// Reads of all rows and nothing else: the bytes that a sweep of a large island moves.
void read(benchmark::State &state) {
    Island island = independent(kLargeRows);
    const dxIslandProblem problem = island.problem();
    for (auto _ : state) {
        dReal sum = 0;
        for (unsigned i = 0; i < problem.rowCount; ++i)
            sum += problem.rows[i].jacobian[0] + problem.rows[i].jacobian[8] + problem.rows[i].impulseOn1[0] + problem.rows[i].lambda;
        benchmark::DoNotOptimize(sum);
    }
    state.counters["ns/row"] = benchmark::Counter(
        kLargeRows * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

BENCHMARK_CAPTURE(sweep, chain, chain(kSmallRows), Order::Joints);
BENCHMARK_CAPTURE(sweep, independent, independent(kSmallRows), Order::Strided);
BENCHMARK_CAPTURE(sweep, stack_scheduled, stack(), Order::Scheduled);
BENCHMARK_CAPTURE(sweep, stack_shuffled, stack(), Order::Shuffled);
BENCHMARK_CAPTURE(sweep, chain_large, chain(kLargeRows), Order::Joints);
BENCHMARK_CAPTURE(sweep, independent_large, independent(kLargeRows), Order::Strided);
BENCHMARK_CAPTURE(sweep, independent_large_shuffled, independent(kLargeRows), Order::Shuffled);
BENCHMARK_CAPTURE(sweep, pile_scheduled, pile(14), Order::Scheduled);
BENCHMARK_CAPTURE(sweep, pile_shuffled, pile(14), Order::Shuffled);
BENCHMARK(read);

}  // namespace
