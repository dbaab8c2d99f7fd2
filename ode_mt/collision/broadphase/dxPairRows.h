// All pairs of a space, found anew row by row, with SIMD, for calls that keep no pairs.
//
// The pairs of a row are delivered before those of the next row are found, so memory for one row suffices. Filters
// are read in the order of rows, so a pair that they exclude costs no cache miss. Threading: not thread-safe.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <ode/common.h>

#include "collision/broadphase/overlap/dxBoxColumns.h"
#include "collision/pairs/dxMembers.h"
#include "collision/pairs/dxPair.h"

// In this class each geom is paired with those behind it; derived classes pair otherwise.
class dxPairRows {
public:
    using Slot = dxMembers::Slot;

    virtual ~dxPairRows() = default;

    void clear();
    // Adds a geom behind the others.
    void push(dxGeom *geom, Slot slot, const dxPairFilter &filter, const dxBounds &box) {
        pushElement(geom, slot, filter);
        m_listed.push_back(box);
    }
    // Requires a call after the last push(). Then nothing allocates memory.
    void finish() {
        makeRoom();
        for (const dxBounds &box : m_listed) m_boxes.push(box);
    }

    std::size_t geoms() const { return m_elements.size(); }
    // Number of rows: of groups of pairs with the same first geom.
    virtual std::size_t rows() const { return geoms(); }
    // Returns the element that is first in the pairs of a row.
    virtual std::size_t first(std::size_t row) const { return row; }
    // Finds the pairs of a row, in the order of callbacks; returns how many. Valid until the next call.
    virtual std::size_t find(std::size_t row);
    // Returns the element that is second in a pair of those found.
    std::size_t second(std::size_t i) const { return m_found[i]; }

    dxGeom *geom(std::size_t element) const { return m_elements[element].geom; }
    Slot slot(std::size_t element) const { return m_elements[element].slot; }

    // Return the number of boxes that were compared, and of those that overlap, since the last clear().
    std::size_t comparisons() const { return m_comparisons; }
    std::size_t overlaps() const { return m_overlaps; }

protected:
    // push() for an element whose box the derived class keeps.
    void pushElement(dxGeom *geom, Slot slot, const dxPairFilter &filter) {
        m_elements.push_back({geom, slot});
        m_filters.push_back(filter);
        m_mayExclude = m_mayExclude || filter.mayExclude();
    }
    // Makes room for what a row finds.
    void makeRoom();
    // Requires an element that was added with its box, before all that were not.
    const dxBounds &box(std::size_t element) const { return m_listed[element]; }
    // Finds the elements from `begin` on, up to `end`, that overlap a box, and counts them.
    std::size_t findBetween(std::size_t begin, std::size_t end, const dxBoxColumns &boxes, const dxBounds &box) {
        const std::size_t count = m_overlappingRows(boxes, box, begin, end, m_found.data());
        countWork(end - begin, count);
        return count;
    }
    std::size_t findFrom(std::size_t begin, const dxBoxColumns &boxes, const dxBounds &box) {
        return findBetween(begin, boxes.size(), boxes, box);
    }
    void countWork(std::size_t comparisons, std::size_t overlaps) {
        m_comparisons += comparisons;
        m_overlaps += overlaps;
    }
    // Removes those that the filters exclude from what was found; returns how many are left.
    std::size_t keepAgreeing(std::size_t element, std::size_t count) {
        return m_mayExclude ? keepOnlyAgreeing(m_filters[element], count) : count;
    }

    dxBoxColumns m_boxes;
    std::vector<std::uint32_t> m_found;  // elements

private:
    struct Element {
        dxGeom *geom;
        Slot slot;
    };

    std::size_t keepOnlyAgreeing(const dxPairFilter &filter, std::size_t count);

    dxOverlappingRowsKernel m_overlappingRows = dxKernelOfOverlappingRows();
    std::vector<Element> m_elements;
    std::vector<dxPairFilter> m_filters;
    std::vector<dxBounds> m_listed;
    bool m_mayExclude = false;
    std::size_t m_comparisons = 0, m_overlaps = 0;
};
