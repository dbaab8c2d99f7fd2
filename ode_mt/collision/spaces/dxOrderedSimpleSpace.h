// The simple space: pairs each geom with those behind it in the list, from the front on.
#pragma once

#include <vector>

#include "collision/broadphase/dxPairRows.h"
#include "collision/broadphase/overlap/dxBoxColumns.h"
#include "collision/spaces/dxOrderedListSpace.h"

class dxOrderedSimpleSpace final : public dxOrderedListSpace {
public:
    explicit dxOrderedSimpleSpace(dSpaceID parent) : dxOrderedListSpace(parent, dSimpleSpaceClass, dxPairOrder::List) {}

    void collide(void *data, dNearCallback *callback) override;

private:
    dxPairRows &gatherRows() override;
    void deliverAnew(void *data, dNearCallback *callback) override;
    void walk(void *data, dNearCallback *callback, const dxOrderedPair *after) override;
    bool walkRows(void *data, dNearCallback *callback);
    void walkFrom(dxGeom *g1, dxGeom *g2, void *data, dNearCallback *callback);
    bool findListed();
    bool areBoxesUpToDate() const;

    dxPairRows m_rows;
    // Scratch of a walk of a small space: the geoms in the order of the list, and the overlapping ones.
    std::vector<dxGeom *> m_listed;
    dxBoxColumns m_boxes;
    std::vector<dxSlotPair> m_overlaps;
    std::vector<dxOrderedPair> m_walked;
    std::size_t m_overlapsWalked = 0;  // at the last walk by vectors
};
