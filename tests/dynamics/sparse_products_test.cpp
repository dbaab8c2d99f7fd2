// Products without zeros are those with them, for every instruction set of this machine.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include "aligned_numbers.h"
#include "dynamics/solve/dxLaneProducts.h"
#include "dynamics/solve/dxSparseProducts.h"
#include "instruction_sets.h"

namespace {

constexpr unsigned kBlocks = 5;

// Lines for some positions of a vector, and the same with lines of zeros for all others.
struct Products {
    Products(unsigned length, unsigned sparsity, unsigned seed) : random(seed), count(length) {
        const unsigned rowSkip = kBlocks * kLineLanes;
        matrix.resize(std::size_t(count) * rowSkip + kLineLanes);
        for (unsigned position = 0; position < count; ++position) {
            columns.push_back(position);
            factors.push_back(number());
        }
        for (unsigned block = 0; block < kBlocks; ++block) {
            begins.push_back(static_cast<unsigned>(positions.size()));
            for (unsigned position = 0; position < count; ++position)
                if (random() % sparsity == 0) addLine(position, &matrix[position * rowSkip + block * kLineLanes]);
            counts.push_back(static_cast<unsigned>(positions.size()) - begins.back());
            wanted.push_back(block != 2);
        }
        factors.push_back(0);
        positions.push_back(0);
        lines.resize(lines.size() + kLineLanes);
    }

    void addLine(unsigned position, dReal *line) {
        for (unsigned lane = 0; lane < kLineLanes; ++lane) {
            line[lane] = random() % 3 == 0 ? -dReal(0) : number();
            lines.push_back(line[lane]);
        }
        positions.push_back(position);
    }

    dReal number() { return std::uniform_real_distribution<dReal>(-1, 1)(random); }

    std::mt19937 random;
    unsigned count;
    AlignedNumbers matrix, lines;
    std::vector<dReal> factors;
    std::vector<unsigned> columns, begins, counts, positions, wanted;
};

void expectSame(const Products &products) {
    AlignedNumbers dense(kBlocks * kLineLanes, dReal(5)), sparse = dense;
    dxComputeLaneProducts({products.matrix.data(), kBlocks * kLineLanes, products.columns.data(), products.factors.data(),
                           products.count, 0, kBlocks, products.wanted.data(), dense.data()});
    dxComputeSparseProducts({products.begins.data(), products.counts.data(), products.lines.data(),
                             products.positions.data(), products.factors.data(), products.count, 0, kBlocks,
                             products.wanted.data(), sparse.data()});
    for (unsigned row = 0; row < kBlocks * kLineLanes; ++row) {
        if (products.wanted[row / kLineLanes] == 0)
            ASSERT_EQ(sparse[row], 5) << row;
        else
            ASSERT_EQ(std::memcmp(&dense[row], &sparse[row], sizeof(dReal)), 0) << row;
    }
}

}  // namespace

TEST(SparseProducts, AreThoseWithZeros) {
    for (const std::int64_t set : instructionSets())
        onInstructionSet(set, [] {
            for (unsigned count = 0; count < 70; ++count)
                for (const unsigned sparsity : {1u, 2u, 5u, 20u})
                    ASSERT_NO_FATAL_FAILURE(expectSame(Products(count, sparsity, count))) << count << " positions";
        });
}

TEST(SparseProducts, MarksLinesThatAreNotZero) {
    for (const std::int64_t set : instructionSets())
        onInstructionSet(set, [] {
            std::mt19937 random(3);
            for (const std::size_t count : {1u, 63u, 64u, 65u, 200u}) {
                AlignedNumbers row(count * kLineLanes, -dReal(0));
                std::vector<bool> isMarked(count);
                for (std::size_t line = 0; line < count; line += 1 + random() % 3) {
                    row[line * kLineLanes + random() % kLineLanes] = std::numeric_limits<dReal>::denorm_min();
                    isMarked[line] = true;
                }
                std::vector<std::uint64_t> bits((count + 63) / 64, ~std::uint64_t{0});
                dxMarkLines(row.data(), count, bits.data());
                for (std::size_t bit = 0; bit < 64 * bits.size(); ++bit)
                    ASSERT_EQ((bits[bit / 64] >> (bit % 64) & 1) != 0, bit < count && isMarked[bit]) << bit;
            }
        });
}
