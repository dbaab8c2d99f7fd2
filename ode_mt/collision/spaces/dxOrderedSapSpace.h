// The sweep-and-prune (SAP) space: geoms are sorted along an axis (dxSapPairOrder). It keeps its geoms in two arrays, as upstream's does
// (dxSapCleaner). docs/collision.md.
#pragma once

#include "collision/spaces/dxOrderedSpace.h"
#include "collision/spaces/dxSapCleaner.h"
#include "collision/spaces/dxSapPairOrder.h"
#include "collision/spaces/dxSapState.h"
#include "collision/spaces/dxSapWalker.h"

class dxOrderedSapSpace final : public dxOrderedSpace {
public:
    // `axes`: dSAP_AXES_XYZ and so on, or any number.
    dxOrderedSapSpace(dSpaceID parent, int axes);
    ~dxOrderedSapSpace() override;

    dxGeom *getGeom(int i) override;
    void dirty(dxGeom *geom) override { m_cleaner.makeDirty(geom); }
    void computeAABB() override {}  // always infinite
    void cleanGeoms() override { m_cleaner.clean(); }
    void collide2(void *data, dxGeom *geom, dNearCallback *callback) override;

private:
    dxSapState m_state;
    dxSapCleaner m_cleaner;
    dxSapPairOrder m_order;
    dxSapWalker m_walker;
};
