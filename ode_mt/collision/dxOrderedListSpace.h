// A space in which upstream walks a list of geoms: the simple and the hash space.
//
// Upstream moves a geom to the front of its list when it changes, and only then. Of two members, the one with the higher
// rank stands further to the front.
#pragma once

#include <vector>

#include "collision/dxOrderedSpace.h"

class dxOrderedListSpace : public dxOrderedSpace {
public:
    void cleanGeoms() override;
    void collide2(void *data, dxGeom *geom, dNearCallback *callback) override;

protected:
    using dxOrderedSpace::dxOrderedSpace;

    bool ranksAreRight() const override { return !m_irregular; }

private:
    void gatherDirty();
    void rankBehindClean(dxGeom *geom, dxRank rank);

    std::vector<dxGeom *> m_dirty;  // front first
    bool m_irregular = false;       // there are dirty geoms behind clean ones
};
