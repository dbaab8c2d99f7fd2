// Boxes by slot, each packed for one comparison with any other.
//
// Two boxes are disjoint if one begins behind the end of the other on some axis: low > other's high, or -high >
// -(other's low). With the six left sides of a box in one array and its six right sides in another, that is one
// comparison of six lanes, branch-free and without gathers, for pairs in random order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "collision/pairs/dxPair.h"
#include "core/dxBounds.h"
#include "core/dxCacheLine.h"
#include "core/dxPrefetch.h"

class dxPackedBoxes {
public:
    using Marks = std::uint8_t;
    static constexpr std::size_t kLanes = 8;  // from a side of one box to that of the next
    static constexpr Marks kKnown = 1;    // both boxes of a pair are known
    static constexpr Marks kChanged = 2;  // and one of them has changed

    // New boxes have no marks.
    void resize(std::size_t boxes);
    std::size_t size() const { return m_marks.size(); }  // the last to grow, if memory has run out before

    void set(std::size_t slot, const dxBounds &box) {
        Row &begin = m_begins[slot], &end = m_ends[slot];
        for (int axis = 0; axis < 3; ++axis) {
            begin.lanes[axis] = box.low(axis);
            begin.lanes[3 + axis] = -double(box.high(axis));
            end.lanes[axis] = box.high(axis);
            end.lanes[3 + axis] = -double(box.low(axis));
        }
    }

    dxBounds box(std::size_t slot) const {
        dxBounds box;
        for (int axis = 0; axis < 3; ++axis) {
            box.v[2 * axis] = static_cast<dReal>(m_begins[slot].lanes[axis]);
            box.v[2 * axis + 1] = static_cast<dReal>(m_ends[slot].lanes[axis]);
        }
        return box;
    }

    // Prefetches a box for write.
    void prefetchForWrite(std::size_t slot) const {
        dxPrefetch::lineForWrite(&m_begins[slot]);
        dxPrefetch::lineForWrite(&m_ends[slot]);
    }

    Marks &marks(std::size_t slot) { return m_marks[slot]; }
    Marks marks(std::size_t slot) const { return m_marks[slot]; }
    const double *begin(std::size_t slot) const { return m_begins[slot].lanes; }
    const double *end(std::size_t slot) const { return m_ends[slot].lanes; }

private:
    struct alignas(kCacheLine) Row {
        double lanes[kLanes] = {};  // the last two stay zero
    };

    std::vector<Row> m_begins, m_ends;
    std::vector<Marks> m_marks;
};

// Writes those of the candidates that are pairs: by their marks, and because their boxes overlap as by
// dxBounds::overlaps. Returns how many; `pairs` has room for `count`.
std::size_t dxOverlappingCandidates(const dxPackedBoxes &boxes, const dxSlotPair *candidates, std::size_t count,
                                    dxSlotPair *pairs);

// Writes the numbers of those from `first` to `end` whose boxes overlap that of a slot, in rising order; returns how many. `slots` has room for
// as many numbers as there are from first to end. Marks do not matter.
using dxOverlappingSlotsKernel = std::size_t (*)(const dxPackedBoxes &boxes, std::size_t slot, std::size_t first, std::size_t end,
                                                 std::uint32_t *slots);
// Returns that function for this machine's instruction set.
dxOverlappingSlotsKernel dxKernelOfOverlappingSlots();
