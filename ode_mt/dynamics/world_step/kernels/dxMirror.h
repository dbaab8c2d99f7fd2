// Computes the other triangle of a symmetric matrix, by cache lines of lanes.
#pragma once

#include <cstddef>

#include <ode/common.h>

struct dxMirrorTask {
    dReal *rows;          // aligned to the cache's lines, as are all rows; room for whole lines of them
    std::size_t rowSkip;  // between rows: a multiple of kLineLanes, no less than n
    std::size_t n;
    std::size_t first;  // the first row whose lower triangle is there
    std::size_t begin, end;  // columns: whole lines, but that the last may end with n
};

// Writes element (j, i) for i >= first, i > j from (i, j), for columns i from begin to end - 1. In these lines, lanes before
// `first` (of rows before it) and from n on become 0.
void dxMirrorLower(const dxMirrorTask &task);
