// Numbers of one body and of two: vectors and matrices of its six directions (linear, then angular), padded to a cache line, so that
// kernels read a column in SIMD vectors of any width. All are doubles, whatever dReal is.
#pragma once

#include <vector>

#include "core/dxCacheLine.h"

constexpr unsigned kBodyAxes = 6, kBodyLanes = 8;

// A velocity, a force, one body's side of a row. Lanes from kBodyAxes on are 0.
struct alignas(kCacheLine) dxBodyVector {
    double lane[kBodyLanes];
};
static_assert(sizeof(dxBodyVector) == kCacheLine, "a vector is a cache line");

// A 6 x 6 matrix by columns. Rows from kBodyAxes on are 0.
struct dxBodyBlock {
    dxBodyVector column[kBodyAxes];
};

using dxBodyVectors = std::vector<dxBodyVector>;
using dxBodyBlocks = std::vector<dxBodyBlock>;

// inv(M) of a body, the inertia in the world's frame.
struct dxInverseMass {
    double mass;
    double inertia[3][3];
};
