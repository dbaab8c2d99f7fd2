// The simple space: pairs each geom with those behind it in the list, from the front on.
#pragma once

#include "collision/broadphase/dxPairRows.h"
#include "collision/spaces/dxOrderedListSpace.h"

class dxOrderedSimpleSpace final : public dxOrderedListSpace {
public:
    explicit dxOrderedSimpleSpace(dSpaceID parent) : dxOrderedListSpace(parent, dSimpleSpaceClass, dxPairOrder::List) {}

private:
    dxPairRows &gatherRows() override;
    void walk(void *data, dNearCallback *callback, const dxOrderedPair *after) override;
    bool walkRows(void *data, dNearCallback *callback);
    void walkFrom(dxGeom *g1, dxGeom *g2, void *data, dNearCallback *callback);
    bool areBoxesUpToDate() const;

    dxPairRows m_rows;
};
