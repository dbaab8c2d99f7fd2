// All pairs of a sweep-and-prune space, found anew by a sweep along its first axis, in upstream's order (docs/collision.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "collision/broadphase/dxPairRows.h"
#include "collision/broadphase/overlap/dxAxisSap.h"
#include "collision/spaces/dxSapBox.h"

class dxSapRows final : public dxPairRows {
public:
    // Begins with rows for so many geoms that are swept.
    void clear(std::size_t swept);
    // Adds a geom that is swept. Requires the order of the sort.
    void pushSwept(dxGeom *geom, Slot slot, const dxPairFilter &filter, const dxSapBox &box);
    // Adds a geom that is infinite on the axis. Requires the order of the list, and that all that are swept have been added.
    void pushInfinite(dxGeom *geom, Slot slot, const dxPairFilter &filter) { pushElement(geom, slot, filter); }
    // Requires a call after the last one was added; if any is infinite, with the places of the swept geoms in the sort, in the order of
    // the list.
    void finish(const std::vector<std::uint32_t> &places);

    // Each swept geom with those behind it; then each infinite one with those behind it and all that are swept.
    std::size_t find(std::size_t row) override;

private:
    std::size_t pairInfinite(std::size_t row);

    dxMeetBehindKernel m_meetBehind = dxKernelOfMeetBehind();
    dxSapColumns m_columns;  // of swept ones
    std::vector<std::uint32_t> m_places;
};
