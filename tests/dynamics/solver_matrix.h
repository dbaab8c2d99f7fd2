// A symmetric matrix in the layout of Dantzig's algorithm, all of whose rows have been taken, and a set C of some of them.
#pragma once

#include <numeric>
#include <random>
#include <vector>

#include "aligned_numbers.h"
#include "dynamics/world_step/exact/dxIndexSets.h"
#include "dynamics/world_step/exact/dxLcpMatrix.h"

struct SolverMatrix {
    // One element of `sparsity` is not 0.
    SolverMatrix(unsigned rows, unsigned sparsity, unsigned seed)
        : random(seed), n(rows), lower(makeLower(sparsity)), order(makeOrder()), storage(dxLcpMatrix::size(n)), words(dxIndexSets::kWords * n),
          source(lower.data(), n, order.data(), n), A(source, n, 0, storage.data()), sets(n, 0, words.data()) {
        for (unsigned i = 0; i < n; ++i) A.take(i, true);
        A.mirror();
    }

    dReal number() { return std::uniform_real_distribution<dReal>(-1, 1)(random); }

    std::mt19937 random;
    const unsigned n;
    std::vector<dReal> lower;
    std::vector<unsigned> order;
    AlignedNumbers storage;
    std::vector<unsigned> words;
    const dxReorderedTriangle source;
    dxLcpMatrix A;
    dxIndexSets sets;

private:
    std::vector<dReal> makeLower(unsigned sparsity) {
        std::vector<dReal> elements(std::size_t(n) * n);
        for (dReal &element : elements) element = random() % sparsity == 0 ? number() : dReal(0);
        return elements;
    }
    std::vector<unsigned> makeOrder() const {
        std::vector<unsigned> places(n);
        std::iota(places.begin(), places.end(), 0u);
        return places;
    }
};
