// Products of rows of a sparse symmetric matrix with a vector, a row a lane, without most of the products that are zero:
// the kernels of dxSparseRows.
#pragma once

#include <ode/common.h>

#include <cstddef>
#include <cstdint>

// A block has as many rows as half a cache line has elements. A block stores such a piece, an element a row, for each
// position of the vector at which one of its rows has an element.
struct dxSparseProductsTask {
    const unsigned *begins, *counts;  // by block: of its pieces
    const dReal *pieces;              // aligned to their length
    const unsigned *positions;        // of the pieces, rising in a block
    const dReal *factors;             // the vector
    unsigned count;                   // its length
    unsigned beginBlock, endBlock;
    const unsigned *wanted;  // by block: 0 if none of its rows is wanted
    dReal *result;           // by row, from block 0 on
};

// result(row) = the sum of products, for all rows of the wanted blocks: that of dxComputeLaneProducts but for its zeros,
// which changes no bit if everything is finite and results are rounded to nearest (docs/exact.md).
void dxComputeSparseProducts(const dxSparseProductsTask &task);

// Sets bit p of `bits` if one of the elements of piece p is not zero, for each of `pieces` pieces at `row`; clears all others
// up to a multiple of 64.
void dxMarkPieces(const dReal *row, std::size_t pieces, std::uint64_t *bits);
