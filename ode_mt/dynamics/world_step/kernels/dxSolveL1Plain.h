// The triangular solves without vectors: the pieces that the kernels share, and whole solves for systems
// too small for vectors to pay.
//
// Straight, upstream's order: rows go in groups of four. Each row subtracts from its right-hand side the
// sum of its products with the columns before its group, added up from +0 in the order of the columns, and
// then its products with the columns of its group, one by one. A row after the last whole group has two
// sums, of the even and of the odd columns.
//
// Transposed: results come from the last to the first. One to three results without a sum are followed by
// groups of four, which subtract the sum of the products with the results after the group, added up from
// +0 in falling order, and then those of the group, one by one.
#pragma once

#include <ode/common.h>

#include <cstddef>

#include "dynamics/world_step/kernels/dxPair.h"

namespace dxSolve {

struct FourResults {
    dReal y[4];
};

// The four rows of the group whose diagonal starts at `diagonal`; `sum` holds their columns before it.
template <unsigned Stride>
inline FourResults finishStraightGroup(const dReal *diagonal, std::size_t rowSkip, dReal *b,
                                       const dReal *sum) {
    const dReal *row1 = diagonal + rowSkip, *row2 = row1 + rowSkip, *row3 = row2 + rowSkip;
    const dReal y0 = b[0] - sum[0];
    const dReal y1 = b[Stride] - sum[1] - row1[0] * y0;
    const dReal y2 = b[2 * Stride] - sum[2] - row2[0] * y0 - row2[1] * y1;
    const dReal y3 = b[3 * Stride] - sum[3] - row3[0] * y0 - row3[1] * y1 - row3[2] * y2;
    b[0] = y0;
    b[Stride] = y1;
    b[2 * Stride] = y2;
    b[3 * Stride] = y3;
    return {{y0, y1, y2, y3}};
}

// Row `index`, which comes after the last group of four.
template <unsigned Stride>
inline void solveStraightSingle(const dReal *row, dReal *B, std::size_t index) {
    dReal even = 0, odd = 0;
    std::size_t column = 0;
    if constexpr (Stride == 1) {
        dxPair sum = {0, 0};
        // Results after the groups were stored one by one just now: a load of two would wait for them.
        for (const std::size_t grouped = index / 4 * 4; column < grouped; column += 4) {
            sum += dxLoadPair(row + column) * dxLoadPair(B + column);
            sum += dxLoadPair(row + column + 2) * dxLoadPair(B + column + 2);
        }
        even = sum[0];
        odd = sum[1];
    }
    for (; column + 1 < index; column += 2) {
        even += row[column] * B[column * Stride];
        odd += row[column + 1] * B[(column + 1) * Stride];
    }
    if (index % 2 != 0) even += row[index - 1] * B[(index - 1) * Stride];
    B[index * Stride] -= even + odd;
}

template <unsigned Stride>
inline void solveStraightPlain(const dReal *L, dReal *B, std::size_t rowCount, std::size_t rowSkip) {
    std::size_t first = 0;
    for (; first + 4 <= rowCount; first += 4) {
        const dReal *row0 = L + first * rowSkip, *row1 = row0 + rowSkip, *row2 = row1 + rowSkip,
                    *row3 = row2 + rowSkip;
        dReal sum0 = 0, sum1 = 0, sum2 = 0, sum3 = 0;
        for (std::size_t column = 0; column < first; ++column) {
            const dReal q = B[column * Stride];
            sum0 += row0[column] * q;
            sum1 += row1[column] * q;
            sum2 += row2[column] * q;
            sum3 += row3[column] * q;
        }
        const dReal sum[4] = {sum0, sum1, sum2, sum3};
        finishStraightGroup<Stride>(row0 + first, rowSkip, B + first * Stride, sum);
    }
    for (; first < rowCount; ++first) solveStraightSingle<Stride>(L + first * rowSkip, B, first);
}

// The four results of the group from row `first` on; `sum` holds the rows after it.
template <unsigned Stride, class Rows>
__attribute__((always_inline)) inline FourResults finishTransposedGroup(const Rows &L, std::size_t first, dReal *B,
                                                                         const dReal *sum) {
    const dReal *row1 = L(first + 1) + first, *row2 = L(first + 2) + first, *row3 = L(first + 3) + first;
    dReal *const b = B + first * Stride;
    const dReal y3 = b[3 * Stride] - sum[3];
    const dReal y2 = b[2 * Stride] - sum[2] - row3[2] * y3;
    const dReal y1 = b[Stride] - sum[1] - row3[1] * y3 - row2[1] * y2;
    const dReal y0 = b[0] - sum[0] - row3[0] * y3 - row2[0] * y2 - row1[0] * y1;
    b[0] = y0;
    b[Stride] = y1;
    b[2 * Stride] = y2;
    b[3 * Stride] = y3;
    return {{y0, y1, y2, y3}};
}

// The results from row `first` on, none to three, which have no group.
template <unsigned Stride, class Rows>
__attribute__((always_inline)) inline void finishTransposedLast(const Rows &L, std::size_t first, dReal *B,
                                                                 std::size_t rowCount) {
    const std::size_t rows = rowCount - first;
    dReal *const b = B + first * Stride;
    if (rows == 2) {
        b[0] -= L(first + 1)[first] * b[Stride];
    } else if (rows == 3) {
        const dReal *row1 = L(first + 1) + first, *row2 = L(first + 2) + first;
        b[Stride] -= row2[1] * b[2 * Stride];
        b[0] = b[0] - row2[0] * b[2 * Stride] - row1[0] * b[Stride];
    }
}

template <unsigned Stride, class Rows>
inline void solveTransposedPlain(const Rows &L, dReal *B, std::size_t rowCount) {
    std::size_t first = rowCount - rowCount % 4;
    finishTransposedLast<Stride>(L, first, B, rowCount);
    while (first > 0) {
        first -= 4;
        dReal sum0 = 0, sum1 = 0, sum2 = 0, sum3 = 0;
        for (std::size_t index = rowCount; index-- > first + 4;) {
            const dReal *const row = L(index) + first;
            const dReal q = B[index * Stride];
            sum0 += row[0] * q;
            sum1 += row[1] * q;
            sum2 += row[2] * q;
            sum3 += row[3] * q;
        }
        const dReal sum[4] = {sum0, sum1, sum2, sum3};
        finishTransposedGroup<Stride>(L, first, B, sum);
    }
}

}  // namespace dxSolve
