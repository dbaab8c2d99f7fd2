// A lower triangle: where its rows lie, and its skyline, for each row the first column that is not zero. Kernels skip the columns before it;
// docs/exact.md explains why the bits are the same.
//
// Source of skyline storage: Jennings, "A compact storage scheme for the solution of symmetric linear simultaneous equations", 1966.
#pragma once

#include <ode/common.h>

#include <algorithm>
#include <cstddef>

// --- where rows lie --------------------------------------------------------------------------------------------

// One after the other, `skip` elements apart.
class dxRowsApart {
public:
    dxRowsApart(const dReal *first, std::size_t skip) : m_first(first), m_skip(skip) {}
    const dReal *operator()(std::size_t row) const { return m_first + row * m_skip; }

private:
    const dReal *const m_first;
    const std::size_t m_skip;
};

// Anywhere. A row that is taken out of a list leaves the others where they are.
class dxListedRows {
public:
    explicit dxListedRows(const dReal *const *rows) : m_rows(rows) {}
    const dReal *operator()(std::size_t row) const { return m_rows[row]; }

private:
    const dReal *const *const m_rows;
};

// --- skyline ----------------------------------------------------------------------------------------------------

class dxSkyline {
public:
    // Makes a skyline that skips nothing.
    dxSkyline() = default;

    // `begins`: for each row a column, of which those before are zero, of either sign. Rows without an element
    // there begin at their diagonal.
    explicit dxSkyline(const unsigned *begins) : m_begins(begins) {}

    bool skipsZeros() const { return m_begins != nullptr; }

    // Returns a column before which all of the rows are zero.
    std::size_t begin(std::size_t firstRow, std::size_t rows) const {
        if (m_begins == nullptr) return 0;
        unsigned begin = m_begins[firstRow];
        for (std::size_t row = 1; row < rows; ++row) begin = std::min(begin, m_begins[firstRow + row]);
        return begin;
    }

    // The same, or a few before it: a multiple of `step`, a power of two.
    std::size_t begin(std::size_t firstRow, std::size_t rows, std::size_t step) const {
        return begin(firstRow, rows) & ~(step - 1);
    }

private:
    const unsigned *m_begins = nullptr;
};

// Requires n rows, the diagonal included, which start rowSkip elements apart.

// Returns whether no element of rows begin..end-1 is infinite or NaN. May raise FE_INVALID if one is.
bool dxAreRowsFinite(const dReal *triangle, unsigned begin, unsigned end, unsigned rowSkip);

// Writes begins[row], the row's first column that is not +0; its diagonal if there is none before.
void dxFindSkyline(const dReal *triangle, unsigned n, unsigned rowSkip, unsigned *begins);
