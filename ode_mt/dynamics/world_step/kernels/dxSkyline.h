// The skyline of a lower triangle: for each row, its first column that is not zero. Kernels skip the columns before it;
// docs/exact.md explains why the bits are the same.
//
// Source of the idea: Jennings, "A compact storage scheme for the solution of symmetric linear simultaneous equations", 1966.
#pragma once

#include <algorithm>
#include <cstddef>

class dxSkyline {
public:
    // Makes a skyline that skips nothing.
    dxSkyline() = default;

    // `begins`: for each row a column, of which those before are zero, of either sign. Rows without an element
    // there begin at their diagonal.
    explicit dxSkyline(const unsigned *begins) : m_begins(begins) {}

    bool leavesOut() const { return m_begins != nullptr; }

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
