// Boxes in columns: one array for each bound, so that one comparison tests as many boxes as a vector holds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <ode/common.h>

#include "collision/pairs/dxPair.h"
#include "core/dxBounds.h"

class dxBoxColumns {
public:
    std::size_t size() const { return m_size; }
    const dReal *column(int bound) const { return m_bounds.data() + static_cast<std::size_t>(bound) * m_capacity; }
    dxBounds row(std::size_t row) const {
        dxBounds box;
        for (int bound = 0; bound < 6; ++bound) box.v[bound] = column(bound)[row];
        return box;
    }

    void clear() { m_size = 0; }

    void push(const dxBounds &box) {
        if (m_size + kPadding >= m_capacity) grow();
        set(m_size++, box);
    }

    void pop() { --m_size; }

    void set(std::size_t row, const dxBounds &box) {
        dReal *place = m_bounds.data() + row;
        for (int bound = 0; bound < 6; ++bound, place += m_capacity) *place = box.v[bound];
    }

private:
    static constexpr std::size_t kPadding = 64;  // rows that may be read past the last one: the widest vector

    void grow();

    std::size_t m_size = 0, m_capacity = 0;  // rows
    std::vector<dReal> m_bounds;             // the columns, one behind the other
};

// Writes the numbers of the rows from `first` to `end` whose boxes overlap `box`, in rising order; returns how many.
// `rows` has room for as many numbers as there are rows. The comparison is dxBounds::overlaps.
std::size_t dxOverlappingRows(const dxBoxColumns &table, const dxBounds &box, std::size_t first, std::size_t end,
                              std::uint32_t *rows);

// The same function for this machine's instruction set, for many calls.
using dxOverlappingRowsKernel = std::size_t (*)(const dxBoxColumns &table, const dxBounds &box, std::size_t first,
                                                std::size_t end, std::uint32_t *rows);
dxOverlappingRowsKernel dxKernelOfOverlappingRows();

// Writes the pairs of rows whose boxes overlap: of each row before `end`, in order, with those behind it, in order; returns
// how many. `a` is the earlier one. Overwrites `pairs`, which grows if there is no room.
std::size_t dxOverlappingPairs(const dxBoxColumns &table, std::size_t end, std::vector<dxSlotPair> &pairs);
