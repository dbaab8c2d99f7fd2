// Sweep and prune along one axis: the pairs of boxes that are sorted by their lower bounds, row by row, with SIMD, in order.
//
// Each row is compared with those behind it until one begins above its upper bound. That is more work than a cell grid
// (dxCellGridPairs.h) where many boxes overlap on the axis, but the pairs are found in order, only the columns are built
// before the sweep, and the two other axes may be any.
//
// Source of the idea: Cohen, Lin, Manocha and Ponamgi, "I-COLLIDE: an interactive and exact collision detection system for large-scale
// environments", 1995; there the sorted lists of all three axes are kept.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

// Boxes in rising order of their lower bounds on the first axis, none of which is NaN. A NaN elsewhere overlaps nothing.
class dxSapColumns {
public:
    enum Column { low, high, low1, high1, low2, high2, kColumns };

    std::size_t size() const { return m_size; }
    const double *column(int i) const { return m_columns[i].data(); }

    void resize(std::size_t rows);
    template <class Box>
    void set(std::size_t row, const Box &box) {
        m_columns[low][row] = box.low;
        m_columns[high][row] = box.high;
        m_columns[low1][row] = box.low1;
        m_columns[high1][row] = box.high1;
        m_columns[low2][row] = box.low2;
        m_columns[high2][row] = box.high2;
    }

private:
    std::size_t m_size = 0;
    std::vector<double> m_columns[kColumns];  // longer than the table by a vector
};

// The result of comparing one row with the rows behind it.
struct dxSapMeetings {
    std::size_t rows;      // number of rows whose boxes overlap its own
    std::size_t compared;  // number of rows that it was compared with
};

// Writes the numbers of the rows behind `row` whose boxes overlap its own, in rising order. `met` has room for rows.size() numbers.
using dxMeetBehindKernel = dxSapMeetings (*)(const dxSapColumns &rows, std::size_t row, std::uint32_t *met);

// Returns the function for this machine's instruction set.
dxMeetBehindKernel dxKernelOfMeetBehind();
