// A row is taken out of a factorisation with the bits of upstream's dxLDLTRemove.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include "config.h"

#include "matrix.h"

#include "dynamics/world_step/exact/dxFactorRemoval.h"

namespace {

// A factorisation of rows `index` of a symmetric matrix of more rows: neither has to fit the other for the bits.
struct Factorisation {
    Factorisation(unsigned rowCount, unsigned sparsity, unsigned seed) : random(seed), count(rowCount), begins(rowCount) {
        A.resize(std::size_t(all()) * all());
        for (unsigned i = 0; i < all(); ++i)
            for (unsigned j = 0; j <= i; ++j) A[i * all() + j] = A[j * all() + i] = number(sparsity);
        L.resize(std::size_t(count) * count);
        for (unsigned i = 0; i < count; ++i) {
            d.push_back(1 + std::fabs(number(1)));
            index.push_back(i * 7 % all());
            begins[i] = sparsity > 1 ? random() % (i + 1) : 0;
            for (unsigned j = begins[i]; j < i; ++j) L[i * count + j] = number(sparsity);
        }
    }

    unsigned all() const { return count + 3 + count % 7; }  // prime to 7, or not: an index may come twice

    dReal number(unsigned sparsity) {
        if (random() % sparsity != 0) return random() % 2 ? dReal(0) : -dReal(0);
        return std::uniform_real_distribution<dReal>(-0.9, 0.9)(random);
    }

    std::mt19937 random;
    unsigned count;
    std::vector<dReal> A, L, d;
    std::vector<unsigned> index, begins;
};

Factorisation removedByUpstream(Factorisation factors, unsigned r) {
    std::vector<dReal *> rows;
    for (unsigned i = 0; i < factors.all(); ++i) rows.push_back(&factors.A[i * factors.all()]);
    std::vector<dReal> storage(3 * factors.all() + 8);
    std::vector<dReal> L(std::size_t(factors.all()) * factors.all());  // its rows are as far apart as A's at least
    for (unsigned i = 0; i < factors.count; ++i)
        std::copy_n(&factors.L[i * factors.count], i, &L[i * factors.all()]);
    dxLDLTRemove(rows.data(), factors.index.data(), L.data(), factors.d.data(), factors.all(), factors.count, r,
                 factors.all(), storage.data());
    for (unsigned i = 0; i + 1 < factors.count; ++i)
        std::copy_n(&L[i * factors.all()], i, &factors.L[i * factors.count]);
    return factors;
}

Factorisation removed(Factorisation factors, unsigned r, bool skipsZeros) {
    std::vector<dReal *> rows;
    for (unsigned i = 0; i < factors.count; ++i) rows.push_back(&factors.L[i * factors.count]);
    std::vector<dReal> storage(dxFactorRemovalStorage(factors.count));
    dxRemoveFactorRow({rows.data(), factors.d.data(), factors.count, r, &factors.A[factors.index[r] * factors.all()],
                       factors.index.data(), skipsZeros ? dxSkyline(factors.begins.data()) : dxSkyline(), storage.data()});
    const std::vector<dReal> L = factors.L;
    for (unsigned i = 0; i + 1 < factors.count; ++i)
        std::copy_n(&L[static_cast<std::size_t>(rows[i] - factors.L.data())], i, &factors.L[i * factors.count]);
    return factors;
}

void expectSame(const Factorisation &ours, const Factorisation &upstream) {
    for (unsigned i = 0; i + 1 < ours.count; ++i) {
        const std::size_t row = std::size_t(i) * ours.count;
        ASSERT_EQ(std::memcmp(&ours.L[row], &upstream.L[row], i * sizeof(dReal)), 0) << "row " << i;
        ASSERT_EQ(std::memcmp(&ours.d[i], &upstream.d[i], sizeof(dReal)), 0) << "pivot " << i;
    }
}

}  // namespace

TEST(FactorRemoval, HasUpstreamsBits) {
    for (unsigned count = 1; count < 40; ++count)
        for (unsigned r = 0; r < count; ++r) {
            const Factorisation factors(count, 1, count);
            ASSERT_NO_FATAL_FAILURE(expectSame(removed(factors, r, false), removedByUpstream(factors, r)))
                << count << " rows without " << r;
        }
}

// Skipping zeros may change a zero's sign only where it is then added to a number.
TEST(FactorRemoval, HasUpstreamsBitsWithZerosLeftOut) {
    for (unsigned count = 4; count < 120; count += 7)
        for (unsigned r = 0; r < count; r += 3) {
            const Factorisation factors(count, 3, count);
            ASSERT_NO_FATAL_FAILURE(expectSame(removed(factors, r, true), removedByUpstream(factors, r)))
                << count << " rows without " << r;
        }
}
