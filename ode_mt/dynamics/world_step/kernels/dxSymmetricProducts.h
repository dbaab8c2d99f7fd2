// Products of rows of a symmetric matrix with a vector, a row a lane: upstream's dot products (ode/src/fastdot_impl.h), many at a time. Dense, and
// without most of the products that are zero (dxSparseRows).
#pragma once

#include <ode/common.h>

#include <cstddef>
#include <cstdint>

// --- dense -----------------------------------------------------------------------------------------------------

// A block has as many rows as a cache line has elements. Columns of the matrix are read along its rows, which are
// aligned to cache lines.
struct dxLaneProductsTask {
    const dReal *matrix;  // symmetric where it is read
    std::size_t rowSkip;
    const unsigned *columns;  // that take part, in the order of the sum
    const dReal *factors;     // for each of them
    unsigned count;
    unsigned beginBlock, endBlock;
    const unsigned *wanted;  // by half a block: 0 if none of its rows is wanted
    dReal *result;           // by row
};

// result(row) = the sum over the columns of A(row, column) * factor, for all rows of the wanted halves of blocks.
// Upstream's order: four products are added to one another, then to the sum; those left over one by one.
void dxComputeLaneProducts(const dxLaneProductsTask &task);

// --- sparse ----------------------------------------------------------------------------------------------------

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
