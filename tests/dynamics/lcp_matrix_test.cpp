// The LCP's matrix in the solver's order is the problem's, takes no row before its time, and sees which rows are not finite.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include "aligned_numbers.h"
#include "dynamics/world_step/exact/dxLcpMatrix.h"
#include "instruction_sets.h"

namespace {

constexpr dReal kUntouched = -1;

dReal element(std::size_t i, std::size_t j) { return dReal(1 + 1000 * std::max(i, j) + std::min(i, j)); }

// A problem whose rows from `first` on are in random order.
struct Problem {
    Problem(unsigned rows, unsigned firstRow)
        : n(rows), first(firstRow), lower(std::size_t(n) * n, std::numeric_limits<dReal>::quiet_NaN()), order(n),
          storage(dxLcpMatrix::size(n), kUntouched) {
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j <= i; ++j) lower[i * n + j] = element(i, j);
        std::iota(order.begin(), order.end(), 0u);
        std::shuffle(order.begin() + first, order.end(), std::mt19937(n));
    }

    dxReorderedTriangle source() const { return {lower.data(), n, order.data(), n}; }

    void expectRow(const dxLcpMatrix &matrix, unsigned row, unsigned end) const {
        for (unsigned j = row < first ? first : 0; j < end; ++j)
            ASSERT_EQ(matrix.row(row)[j], element(order[row], order[j])) << row << ' ' << j;
    }

    unsigned n, first;
    std::vector<dReal> lower;
    std::vector<unsigned> order;
    AlignedNumbers storage;
};

constexpr unsigned kSizes[] = {1, 7, 20, 64, 65, 100, 150};

}  // namespace

TEST(LcpMatrix, IsTheProblemsInAnotherOrder) {
    for (const std::int64_t set : instructionSets())
        onInstructionSet(set, [] {
            for (const unsigned n : kSizes)
                for (const unsigned first : {0u, n / 3, n - 1}) {
                    Problem problem(n, first);
                    const dxReorderedTriangle source = problem.source();
                    dxLcpMatrix matrix(source, n, first, problem.storage.data());
                    for (unsigned i = first; i < n; ++i) {
                        ASSERT_TRUE(matrix.take(i, true));
                        problem.expectRow(matrix, i, i + 1);
                        if (i % 5 != 0 && i + 1 != n) continue;
                        matrix.mirror();
                        for (unsigned row = 0; row < matrix.end(); ++row) problem.expectRow(matrix, row, matrix.end());
                    }
                }
        });
}

TEST(LcpMatrix, TakesNoRowBeforeItsTime) {
    constexpr unsigned n = 150, first = 10, last = 70;
    Problem problem(n, first);
    const dxReorderedTriangle source = problem.source();
    dxLcpMatrix matrix(source, n, first, problem.storage.data());
    for (unsigned i = first; i <= last; ++i) matrix.take(i, true);
    EXPECT_LT(matrix.end(), last + kLineLanes + 1);
    for (unsigned i = matrix.end(); i < n; ++i)
        for (unsigned j = 0; j < n; ++j) ASSERT_EQ(matrix.row(i)[j], kUntouched) << i << ' ' << j;
}

TEST(LcpMatrix, SeesWhatIsNotFiniteInTheRowsThatItTakes) {
    constexpr unsigned n = 150, bad = 100;
    for (const dReal value : {std::numeric_limits<dReal>::infinity(), std::numeric_limits<dReal>::quiet_NaN()}) {
        Problem problem(n, 0);
        std::iota(problem.order.begin(), problem.order.end(), 0u);
        problem.lower[bad * n + 3] = value;
        const dxReorderedTriangle source = problem.source();
        for (const bool isFinite : {false, true}) {
            dxLcpMatrix matrix(source, n, 0, problem.storage.data());
            for (unsigned i = 0; i < n; ++i)
                ASSERT_EQ(matrix.take(i, isFinite), !isFinite || i < bad / kLineLanes * kLineLanes || i > bad / kLineLanes * kLineLanes)
                    << i;
        }
    }
}
