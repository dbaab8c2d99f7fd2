// Products of rows of a symmetric matrix with a vector, a row a lane: upstream's dot products
// (ode/src/fastdot_impl.h), many at a time.
#pragma once

#include <ode/common.h>

#include <cstddef>

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
