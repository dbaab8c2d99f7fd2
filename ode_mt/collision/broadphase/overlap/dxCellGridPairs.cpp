#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collision/broadphase/overlap/dxCellGridPairs.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include <hwy/highway.h>

#include <algorithm>
#include <limits>

#include "collision/broadphase/overlap/dxBoxLanes-inl.h"
#include "collision/broadphase/overlap/dxCellGridPairs.h"

HWY_BEFORE_NAMESPACE();
namespace dxBroadphaseKernels {
namespace HWY_NAMESPACE {
using Lanes = hn::ScalableTag<double>;
using Mask = hn::Mask<Lanes>;

// A box that is compared with runs of rows.
struct Box {
    BoxLanes<Lanes> lanes;
    std::uint32_t slot;
    bool isChanged;

    static Box ofRow(const dxCellRows &rows, std::size_t row) {
        double bounds[6];
        for (int i = 0; i < 6; ++i) bounds[i] = rows.bound(i)[row];
        return {BoxLanes<Lanes>(bounds), rows.slot(row), rows.isChanged(row)};
    }
};

// Boxes against rows of a table.
class Probe {
public:
    Probe(const dxCellRows &rows, std::vector<dxSlotPair> &pairs) : m_rows(rows), m_pairs(pairs) {
        for (int i = 0; i < 6; ++i) m_columns[i] = rows.bound(i);
    }

    // Compares a box with the rows from `begin` on whose cells are at most `last`.
    HWY_INLINE void testRun(const Box &box, std::size_t begin, double last) {
        const Lanes d;
        const double *const cells = m_rows.cells();
        for (std::size_t first = begin;; first += hn::Lanes(d)) {
            const Mask beyond = hn::Gt(hn::LoadU(d, cells + first), hn::Set(d, last));
            forLanes(lanesLeft(d, hn::Or(beyond, box.lanes.apart(m_columns, first))),
                     [&](std::size_t lane) HWY_ATTR { emit(box, first + lane); });
            if (cells[first + hn::Lanes(d) - 1] > last) return;
        }
    }

private:
    HWY_INLINE void emit(const Box &box, std::size_t row) {
        if (box.isChanged || m_rows.isChanged(row)) m_pairs.push_back({box.slot, m_rows.slot(row)});
    }

    const dxCellRows &m_rows;
    std::vector<dxSlotPair> &m_pairs;
    const double *m_columns[6];
};

// The row at which the cells from cell + offset - 1 on begin, for rising cells.
class Run {
public:
    Run(const dxCellRows &rows, double firstCell, double offset)
        : m_cells(rows.cells()), m_offset(offset),
          m_begin(static_cast<std::size_t>(
              std::lower_bound(m_cells, m_cells + rows.size(), firstCell + offset - 1) - m_cells)) {}

    HWY_INLINE std::size_t begin(double cell) {
        const Lanes d;
        const auto first = hn::Set(d, cell + m_offset - 1);
        std::size_t before;
        do {
            before = hn::CountTrue(d, hn::Lt(hn::LoadU(d, m_cells + m_begin), first));
            m_begin += before;
        } while (before == hn::Lanes(d));
        return m_begin;
    }

    double last(double cell) const { return cell + m_offset + 1; }

private:
    const double *m_cells;
    double m_offset;
    std::size_t m_begin;
};

void sweepWithin(const dxCellRows &rows, dxCellStrides strides, std::size_t begin, std::size_t end,
                 std::vector<dxSlotPair> &pairs) {
    if (begin >= end) return;
    const double *const cells = rows.cells();
    const double first = cells[begin], x = static_cast<double>(strides.x), y = static_cast<double>(strides.y);
    // Visits half of the neighbours, the later ones; the other half finds this box.
    Run runs[] = {{rows, first, y}, {rows, first, x - y}, {rows, first, x}, {rows, first, x + y}};
    Probe probe(rows, pairs);
    for (std::size_t row = begin; row < end; ++row) {
        const Box box = Box::ofRow(rows, row);
        const double cell = cells[row];
        probe.testRun(box, row + 1, cell + 1);
        for (Run &run : runs) probe.testRun(box, run.begin(cell), run.last(cell));
    }
}

void sweepAcross(const dxCellRows &outer, const dxCellRows &inner, dxCellStrides strides, std::size_t begin,
                 std::size_t end, std::vector<dxSlotPair> &pairs) {
    if (begin >= end) return;
    const double *const cells = outer.cells();
    const double first = cells[begin], x = static_cast<double>(strides.x), y = static_cast<double>(strides.y);
    Run runs[] = {{inner, first, -x - y}, {inner, first, -x}, {inner, first, -x + y},
                  {inner, first, -y},     {inner, first, 0},  {inner, first, y},
                  {inner, first, x - y},  {inner, first, x},  {inner, first, x + y}};
    Probe probe(inner, pairs);
    for (std::size_t row = begin; row < end; ++row) {
        const Box box = Box::ofRow(outer, row);
        for (Run &run : runs) probe.testRun(box, run.begin(cells[row]), run.last(cells[row]));
    }
}

void sweepAll(const dxCellRows &rows, const dxBounds &bounds, std::uint32_t slot, bool changed,
              std::vector<dxSlotPair> &pairs) {
    double box[6];
    std::copy(bounds.v, bounds.v + 6, box);
    Probe(rows, pairs).testRun({BoxLanes<Lanes>(box), slot, changed}, 0, std::numeric_limits<double>::max());
}

}  // namespace HWY_NAMESPACE
}  // namespace dxBroadphaseKernels
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxBroadphaseKernels {
HWY_EXPORT(sweepWithin);
HWY_EXPORT(sweepAcross);
HWY_EXPORT(sweepAll);
}  // namespace dxBroadphaseKernels

void dxCellRows::resize(std::size_t rows) {
    constexpr std::size_t kWidest = 8;  // doubles in a vector, which may be read behind the last row
    constexpr double kNever = std::numeric_limits<double>::infinity();
    if (m_columns[6].size() < rows + kWidest)
        for (std::vector<double> &column : m_columns) column.resize(rows + rows / 2 + kWidest);
    std::fill_n(m_columns[6].begin() + static_cast<std::ptrdiff_t>(rows), kWidest, kNever);
    m_slots.resize(rows);
    m_isChanged.resize(rows);
}

void dxCellPairsWithin(const dxCellRows &rows, dxCellStrides strides, std::size_t begin, std::size_t end,
                   std::vector<dxSlotPair> &pairs) {
    HWY_DYNAMIC_DISPATCH(dxBroadphaseKernels::sweepWithin)(rows, strides, begin, end, pairs);
}

void dxCellPairsAcross(const dxCellRows &outer, const dxCellRows &inner, dxCellStrides strides, std::size_t begin,
                   std::size_t end, std::vector<dxSlotPair> &pairs) {
    HWY_DYNAMIC_DISPATCH(dxBroadphaseKernels::sweepAcross)(outer, inner, strides, begin, end, pairs);
}

void dxCellPairsOfBox(const dxCellRows &rows, const dxBounds &box, std::uint32_t slot, bool changed,
                std::vector<dxSlotPair> &pairs) {
    HWY_DYNAMIC_DISPATCH(dxBroadphaseKernels::sweepAll)(rows, box, slot, changed, pairs);
}
#endif
