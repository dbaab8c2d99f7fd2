// Functions of ode/misc.h, in place of upstream's misc.cpp: random numbers (the sequence is dynamics/step/random/dxRandom), and helpers to
// print, fill and compare matrices. A matrix is stored by rows; a row of n numbers takes dPAD(n).
#include <ode/misc.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "config.h"
#include "common.h"
#include "dynamics/step/random/dxRandom.h"

namespace {

template <class Function>
void forEachElement(int rows, int columns, Function function) {
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) function(row, column);
    }
}

// dReal has no order with NaN: as upstream, a NaN difference never becomes the maximum.
dReal larger(dReal maximum, dReal difference) { return difference > maximum ? difference : maximum; }

}  // namespace

extern "C" {

unsigned long dRand() { return dxRandom::drawShared(); }

unsigned long dRandGetSeed() { return dxRandom::sharedSeed(); }

void dRandSetSeed(unsigned long seed) { dxRandom::setSharedSeed(static_cast<std::uint32_t>(seed)); }

int dRandInt(int n) { return dxRandom::toRange(dxRandom::drawShared(), static_cast<std::uint32_t>(n)); }

dReal dRandReal() { return static_cast<dReal>(static_cast<double>(dRand()) / 4294967295.0); }

// Self-test of the generator: the first numbers after seed 0.
int dTestRand() {
    constexpr std::uint32_t expected[] = {0x3c6ef35f, 0x47502932, 0xd1ccf6e9, 0xaaf95334, 0x6252e503};
    std::uint32_t seed = 0;
    for (std::uint32_t number : expected) {
        seed = dxRandom::next(seed);
        if (seed != number) return 0;
    }
    return 1;
}

void dPrintMatrix(const dReal *A, int n, int m, const char *format, FILE *file) {
    for (int row = 0; row < n; ++row) {
        for (int column = 0; column < m; ++column) std::fprintf(file, format, A[row * dPAD(m) + column]);
        std::fputc('\n', file);
    }
}

void dMakeRandomVector(dReal *A, int n, dReal range) {
    std::generate_n(A, std::max(n, 0), [range] { return (dRandReal() * 2 - 1) * range; });
}

void dMakeRandomMatrix(dReal *A, int n, int m, dReal range) {
    for (int row = 0; row < n; ++row) dMakeRandomVector(A + row * dPAD(m), m, range);
}

void dClearUpperTriangle(dReal *A, int n) {
    forEachElement(n, n, [&](int row, int column) {
        if (column > row) A[row * dPAD(n) + column] = 0;
    });
}

dReal dMaxDifference(const dReal *A, const dReal *B, int n, int m) {
    dReal maximum = 0;
    forEachElement(n, m, [&](int row, int column) {
        const int i = row * dPAD(m) + column;
        maximum = larger(maximum, std::fabs(A[i] - B[i]));
    });
    return maximum;
}

dReal dMaxDifferenceLowerTriangle(const dReal *A, const dReal *B, int n) {
    dReal maximum = 0;
    forEachElement(n, n, [&](int row, int column) {
        const int i = row * dPAD(n) + column;
        if (column <= row) maximum = larger(maximum, std::fabs(A[i] - B[i]));
    });
    return maximum;
}

}  // extern "C"
