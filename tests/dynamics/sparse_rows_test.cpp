// Products with the sparse rows are those with the whole matrix, while C gains and loses columns, for every instruction set of this machine; a matrix
// with few zeros is not stored.
#include "dynamics/world_step/exact/dxSparseRows.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "config.h"

#include "util.h"

#include "dynamics/world_step/kernels/dxSymmetricProducts.h"
#include "instruction_sets.h"
#include "solver_matrix.h"

namespace {

constexpr unsigned kRows = 200;

class Arena {
public:
    explicit Arena(std::size_t size) : m_arena(dxAllocateTemporaryWorldProcessMemArena(size, nullptr, nullptr)) { m_arena->ResetState(); }
    ~Arena() { dxFreeTemporaryWorldProcessMemArena(m_arena); }
    Arena(const Arena &) = delete;
    Arena &operator=(const Arena &) = delete;
    dxWorldProcessMemArena *get() const { return m_arena; }

private:
    dxWorldProcessMemArena *const m_arena;
};

void expectProducts(SolverMatrix &matrix, const dxSparseRows &sparse) {
    const unsigned count = matrix.sets.countC();
    std::vector<dReal> factors;
    for (unsigned i = 0; i < count; ++i) factors.push_back(matrix.number());
    const std::vector<unsigned> wanted(2 * (dxLcpBlock(kRows) + 1), 1u);
    AlignedNumbers dense(dxLcpRoundUp(kRows)), products(dxLcpRoundUp(kRows));
    dxComputeLaneProducts({matrix.A.rows(), matrix.A.rowSkip(), matrix.sets.indexes(), factors.data(), count, 0, dxLcpBlock(kRows - 1) + 1,
                           wanted.data(), dense.data()});
    sparse.multiply(factors.data(), kRows, wanted.data(), products.data(), dxLcpWorkers(nullptr));
    ASSERT_EQ(std::memcmp(dense.data(), products.data(), kRows * sizeof(dReal)), 0) << count << " columns";
}

}  // namespace

TEST(SparseRows, HaveTheProductsOfTheMatrix) {
    for (const std::int64_t set : instructionSets())
        onInstructionSet(set, [] {
            SolverMatrix matrix(kRows, 40, 5);
            for (unsigned i = 0; i < 30; ++i) matrix.sets.addNextToC();
            const Arena arena(2 * dxSparseRows::memory(kRows));
            dxSparseRows sparse(matrix.A, matrix.sets, kRows, 0);
            EXPECT_FALSE(sparse.isTried());
            sparse.build(arena.get());
            ASSERT_TRUE(sparse.isBuilt());
            while (matrix.sets.countC() + matrix.sets.countN() < kRows) {
                if (matrix.sets.countC() > 8 && matrix.random() % 4 == 0) {
                    const unsigned position = matrix.random() % matrix.sets.countC();
                    sparse.remove(position);
                    matrix.sets.moveFromCToN(position, matrix.sets.factorRowAt(position));
                } else {
                    const unsigned next = matrix.sets.indexAt(matrix.sets.countC() + matrix.sets.countN());
                    matrix.sets.addNextToC();
                    sparse.append(next);
                }
                ASSERT_NO_FATAL_FAILURE(expectProducts(matrix, sparse));
            }
        });
}

TEST(SparseRows, AreNotBuiltOfADenseMatrix) {
    SolverMatrix matrix(kRows, 2, 5);
    const Arena arena(2 * dxSparseRows::memory(kRows));
    dxSparseRows sparse(matrix.A, matrix.sets, kRows, 0);
    sparse.build(arena.get());
    EXPECT_TRUE(sparse.isTried());
    EXPECT_FALSE(sparse.isBuilt());
}
