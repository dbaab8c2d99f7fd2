// Boxes in columns: one array for each bound, so that one comparison tests as many boxes as a vector holds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <ode/common.h>

#include "collision/dxBounds.h"

class dxBoxTable {
public:
    std::size_t size() const { return m_size; }
    const dReal *column(int bound) const { return m_columns[bound].data(); }

    void clear() { m_size = 0; }

    void push(const dxBounds &box) {
        if (m_size + kPadding >= m_columns[0].size())
            for (auto &column : m_columns) column.resize(2 * m_size + kPadding + 1);
        for (int bound = 0; bound < 6; ++bound) m_columns[bound][m_size] = box.v[bound];
        ++m_size;
    }

    void set(std::size_t row, const dxBounds &box) {
        for (int bound = 0; bound < 6; ++bound) m_columns[bound][row] = box.v[bound];
    }

    // Row `row` of `from` becomes the last row.
    void pushRow(const dxBoxTable &from, std::size_t row) {
        dxBounds box;
        for (int bound = 0; bound < 6; ++bound) box.v[bound] = from.m_columns[bound][row];
        push(box);
    }

private:
    static constexpr std::size_t kPadding = 64;  // elements that may be read past the last row: the widest vector

    std::size_t m_size = 0;
    std::vector<dReal> m_columns[6];
};

// Writes the numbers of the rows from `first` on whose boxes overlap `box`, in rising order; returns how many.
// `rows` has room for table.size() numbers. The comparison is dxBounds::overlaps.
std::size_t dxOverlappingRows(const dxBoxTable &table, const dxBounds &box, std::size_t first,
                              std::uint32_t *rows);
