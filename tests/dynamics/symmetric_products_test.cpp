// Sparse products are the dense ones, for every instruction set of this machine.
#include <gtest/gtest.h>

#include <cfenv>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include "aligned_numbers.h"
#include "dynamics/world_step/kernels/dxSymmetricProducts.h"
#include "instruction_sets.h"

namespace {

constexpr unsigned kBlocks = 6;

// Pieces for some positions of a vector, and the same with zeros for all others.
struct Products {
    Products(unsigned length, unsigned sparsity, unsigned seed) : random(seed), count(length) {
        const unsigned rowSkip = kBlocks * kHalfLine;
        matrix.resize(std::size_t(count) * rowSkip + kHalfLine);
        for (unsigned position = 0; position < count; ++position) {
            columns.push_back(position);
            factors.push_back(number());
        }
        for (unsigned block = 0; block < kBlocks; ++block) {
            begins.push_back(static_cast<unsigned>(positions.size()));
            for (unsigned position = 0; position < count; ++position)
                if (random() % sparsity == 0) addPiece(position, &matrix[position * rowSkip + block * kHalfLine]);
            counts.push_back(static_cast<unsigned>(positions.size()) - begins.back());
            wanted.push_back(block != 2 && block != 3);
        }
        factors.push_back(0);
        positions.push_back(0);
        pieces.resize(pieces.size() + kHalfLine);
    }

    void addPiece(unsigned position, dReal *piece) {
        for (unsigned lane = 0; lane < kHalfLine; ++lane) {
            piece[lane] = random() % 3 == 0 ? -dReal(0) : number();
            pieces.push_back(piece[lane]);
        }
        positions.push_back(position);
    }

    dReal number() { return std::uniform_real_distribution<dReal>(-1, 1)(random); }

    std::mt19937 random;
    unsigned count;
    AlignedNumbers matrix, pieces;
    std::vector<dReal> factors;
    std::vector<unsigned> columns, begins, counts, positions, wanted;
};

void expectSame(const Products &products) {
    AlignedNumbers dense(kBlocks * kHalfLine, dReal(5)), sparse = dense;
    dxComputeLaneProducts({products.matrix.data(), kBlocks * kHalfLine, products.columns.data(), products.factors.data(),
                           products.count, 0, kBlocks / 2, products.wanted.data(), dense.data()});
    dxComputeSparseProducts({products.begins.data(), products.counts.data(), products.pieces.data(),
                             products.positions.data(), products.factors.data(), products.count, 0, kBlocks,
                             products.wanted.data(), sparse.data()});
    for (unsigned row = 0; row < kBlocks * kHalfLine; ++row) {
        if (products.wanted[row / kHalfLine] == 0)
            ASSERT_EQ(sparse[row], 5) << row;
        else
            ASSERT_EQ(std::memcmp(&dense[row], &sparse[row], sizeof(dReal)), 0) << row;
    }
}

}  // namespace

TEST(SymmetricProducts, AreThoseWithZeros) {
    for (const std::int64_t set : instructionSets())
        onInstructionSet(set, [] {
            for (unsigned count = 0; count < 70; ++count)
                for (const unsigned sparsity : {1u, 2u, 5u, 20u})
                    ASSERT_NO_FATAL_FAILURE(expectSame(Products(count, sparsity, count))) << count << " positions";
        });
}

// Numbers whose bits put together would be none.
TEST(SymmetricProducts, MarkingRaisesNothing) {
    for (const std::int64_t set : instructionSets())
        onInstructionSet(set, [] {
            AlignedNumbers row(kHalfLine);
            row[0] = dReal(1.25);
            for (unsigned lane = 1; lane < kHalfLine; ++lane) row[lane] = 2;
            std::uint64_t bits = 0;
            std::feclearexcept(FE_ALL_EXCEPT);
            dxMarkPieces(row.data(), 1, &bits);
            EXPECT_EQ(std::fetestexcept(FE_INVALID), 0);
            EXPECT_EQ(bits, 1u);
        });
}

TEST(SymmetricProducts, MarksPiecesThatAreNotZero) {
    for (const std::int64_t set : instructionSets())
        onInstructionSet(set, [] {
            std::mt19937 random(3);
            for (const std::size_t count : {1u, 63u, 64u, 65u, 200u}) {
                AlignedNumbers row(count * kHalfLine, -dReal(0));
                std::vector<bool> isMarked(count);
                for (std::size_t piece = 0; piece < count; piece += 1 + random() % 3) {
                    row[piece * kHalfLine + random() % kHalfLine] = std::numeric_limits<dReal>::denorm_min();
                    isMarked[piece] = true;
                }
                std::vector<std::uint64_t> bits((count + 63) / 64, ~std::uint64_t{0});
                dxMarkPieces(row.data(), count, bits.data());
                for (std::size_t bit = 0; bit < 64 * bits.size(); ++bit)
                    ASSERT_EQ((bits[bit / 64] >> (bit % 64) & 1) != 0, bit < count && isMarked[bit]) << bit;
            }
        });
}
