// Numbers of one body and of two: vectors and matrices of its six directions (linear, then angular), padded to a cache line, so that
// kernels read a column by vectors of any width.
#pragma once

#include <vector>

constexpr unsigned kBodyAxes = 6, kBodyLanes = 8;

// A velocity, a force, one body's side of a row. Lanes from kBodyAxes on are 0.
struct alignas(64) dxBodyVector {
    double lane[kBodyLanes];
};

// A 6 x 6 matrix by columns. Rows from kBodyAxes on are 0.
struct dxBodyBlock {
    dxBodyVector column[kBodyAxes];
};

using dxBodyVectors = std::vector<dxBodyVector>;
using dxBodyBlocks = std::vector<dxBodyBlock>;
