// The envelope of a lower triangle: for each row, the columns from its first that is not zero on. Kernels leave
// out what lies before it, and docs/lcp.md tells why the bits stay the same.
#pragma once

#include <algorithm>
#include <cstddef>

class dxEnvelope {
public:
    // Nothing is left out.
    dxEnvelope() = default;

    // `begins`: for each row a column, of which those before are zero, of either sign. Rows without an element
    // there begin at their diagonal.
    explicit dxEnvelope(const unsigned *begins) : m_begins(begins) {}

    bool leavesOut() const { return m_begins != nullptr; }

    // All columns before it are zero in all of the rows.
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
