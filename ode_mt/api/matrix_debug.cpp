// ODE's helpers to print, fill and compare matrices (ode/misc.h), in place of upstream's misc.cpp.
// A matrix is stored by rows; a row of n numbers takes dPAD(n).
#include <ode/misc.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "config.h"
#include "common.h"

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
