// Forward solves that are kept from row to row give the bits of a solve for one right-hand side, while C grows and loses rows, for every instruction
// set of this machine.
#include "dynamics/world_step/exact/dxForwardSolves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "core/dxCacheLine.h"
#include "dynamics/world_step/kernels/dxSolveL1.h"
#include "instruction_sets.h"
#include "solver_matrix.h"

namespace {

constexpr unsigned kRows = 150;

class Factor {
public:
    explicit Factor(SolverMatrix &matrix) : m_elements(std::size_t(kRows) * kRows), m_rows(kRows), m_d(kRows) {
        for (dReal &element : m_elements) element = matrix.number() / 4;
        for (dReal &d : m_d) d = 1 + matrix.number() / 2;
        for (unsigned i = 0; i < kRows; ++i) m_rows[i] = &m_elements[std::size_t(i) * kRows];
    }

    const dReal *const *rows() const { return m_rows.data(); }
    const dReal *d() const { return m_d.data(); }

    // Removes a row: those after it are others then.
    void remove(unsigned row, SolverMatrix &matrix) {
        for (unsigned i = row; i < kRows; ++i)
            for (unsigned k = row; k < i; ++k) m_elements[std::size_t(i) * kRows + k] = matrix.number() / 4;
    }

    // A copy by rows, as the solve for one right-hand side reads it.
    void expectSolution(SolverMatrix &matrix, unsigned column, const dReal *solved) const {
        const unsigned count = matrix.sets.countC();
        std::vector<dReal> y;
        for (unsigned row = 0; row < count; ++row) y.push_back(matrix.A.row(matrix.sets.factorIndexes()[row])[column]);
        dxSolveL1Straight<1>(m_elements.data(), y.data(), count, kRows);
        ASSERT_EQ(std::memcmp(y.data(), solved, count * sizeof(dReal)), 0) << "column " << column << ", " << count << " rows";
    }

private:
    std::vector<dReal> m_elements;
    std::vector<const dReal *> m_rows;
    std::vector<dReal> m_d;
};

}  // namespace

TEST(ForwardSolves, AreThoseOfOneRightHandSide) {
    for (const std::int64_t set : instructionSets())
        onInstructionSet(set, [] {
            SolverMatrix matrix(kRows, 1, 3);
            Factor factor(matrix);
            const dxSkyline noSkyline;
            AlignedNumbers storage(dxForwardSolves::size(kRows, 0));
            std::vector<unsigned> words(dxForwardSolves::words(kRows));
            dxForwardSolves solves(matrix.A, matrix.sets, factor.rows(), noSkyline, kRows, 0, storage.data(), words.data());
            std::vector<dReal> solved(kRows), scaled(kRows), copy(kRows);
            const dxLcpWorkers alone(nullptr);
            while (matrix.sets.countC() + matrix.sets.countN() < kRows) {
                if (matrix.sets.countC() > 8 && matrix.random() % 6 == 0) {
                    const unsigned position = matrix.random() % matrix.sets.countC(), row = matrix.sets.factorRowAt(position);
                    factor.remove(row, matrix);
                    solves.forgetFrom(row);
                    matrix.sets.moveFromCToN(position, row);
                } else {
                    matrix.sets.addNextToC();
                }
                const unsigned column = matrix.random() % kRows, count = matrix.sets.countC();
                solves.solve(column, factor.d(), {solved.data(), scaled.data(), copy.data()}, alone);
                ASSERT_NO_FATAL_FAILURE(factor.expectSolution(matrix, column, solved.data()));
                for (unsigned row = 0; row < count; ++row) {
                    ASSERT_EQ(scaled[row], solved[row] * factor.d()[row]);
                    ASSERT_EQ(copy[row], scaled[row]);
                }
            }
        });
}
