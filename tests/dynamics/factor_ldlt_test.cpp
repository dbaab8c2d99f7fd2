// The factorisation gives upstream's bits, for every instruction set of this machine.
#include <gtest/gtest.h>

#include <ode/matrix.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include "dynamics/world_step/kernels/dxFactorLDLT.h"
#include "dynamics/world_step/kernels/dxTriangle.h"
#include "instruction_sets.h"

namespace {

struct Matrix {
    // Positive definite, or indefinite and badly scaled; nothing above the diagonal may be read. Rows begin up to
    // `reach` columns before their diagonal.
    Matrix(unsigned rows, unsigned rowSkip, bool isWild, unsigned reach, unsigned seed)
        : n(rows),
          skip(rowSkip),
          elements(std::size_t(rows) * rowSkip, std::numeric_limits<dReal>::quiet_NaN()),
          d(rows) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> number(-1, 1);
        for (unsigned i = 0; i < n; ++i) {
            const unsigned begin = i - std::min(i, unsigned(random() % (reach + 1)));
            for (unsigned j = 0; j < i; ++j) {
                const bool isZero = j < begin || random() % 3 == 0;
                elements[i * skip + j] = isZero ? dReal(j < begin || random() % 2 ? 0. : -0.)
                                                : dReal(number(random) * (isWild ? std::pow(10, 5 * number(random)) : 1));
            }
            elements[i * skip + i] = dReal(isWild ? number(random) : n + number(random));
        }
    }

    // Equal below the diagonal, and in d.
    bool operator==(const Matrix &other) const {
        bool isSame = std::memcmp(d.data(), other.d.data(), n * sizeof(dReal)) == 0;
        for (unsigned i = 0; i < n; ++i)
            isSame =
                isSame && std::memcmp(&elements[i * skip], &other.elements[i * skip], i * sizeof(dReal)) == 0;
        return isSame;
    }

    unsigned n, skip;
    std::vector<dReal> elements, d;
};

void factor(Matrix &matrix) {
    std::vector<dReal> storage(dxFactorLDLTStorage(matrix.n) + 16);
    void *aligned = storage.data();
    std::size_t space = storage.size() * sizeof(dReal);
    std::align(64, 1, aligned, space);
    std::vector<unsigned> begins(matrix.n);
    dxFindSkyline(matrix.elements.data(), matrix.n, matrix.skip, begins.data());
    dxFactorLDLT(matrix.elements.data(), matrix.d.data(), matrix.n, matrix.skip, dxSkyline(begins.data()),
                 static_cast<dReal *>(aligned));
}

}  // namespace

TEST(FactorLDLT, GivesUpstreamsBits) {
    for (const std::int64_t set : instructionSets()) {
        onInstructionSet(set, [] {
            for (unsigned n = 1; n < 200; n += n < 70 ? 1 : 13) {
                for (unsigned seed = 0; seed < 12; ++seed) {
                    const unsigned reach = seed % 3 == 0 ? 6 : seed % 3 == 1 ? n / 2 : 2 * n;
                    Matrix upstream(n, n + seed, seed % 2 != 0, reach, seed), ours = upstream;
                    dFactorLDLT(upstream.elements.data(), upstream.d.data(), static_cast<int>(n),
                                static_cast<int>(upstream.skip));
                    factor(ours);
                    EXPECT_TRUE(upstream == ours) << n << " rows, seed " << seed;
                }
            }
        });
    }
}
