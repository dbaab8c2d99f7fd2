#include "collision/spaces/dxOrderedQuadTreeSpace.h"

#include "util.h"

dxOrderedQuadTreeSpace::dxOrderedQuadTreeSpace(dSpaceID parent, const dReal *centre, const dReal *extents, int depth)
    : dxOrderedSpace(parent, dQuadTreeSpaceClass, dxPairOrder::Blocks, m_cleaner, m_order, m_walker), m_tree(centre, extents, depth),
      m_cleaner(geoms(), foundPairs(), m_tree), m_order(geoms(), foundPairs(), m_tree, m_cleaner.ranks()),
      m_walker(*this, m_tree, m_cleaner, m_order) {
    for (int axis = 0; axis < 3; ++axis) {
        aabb[2 * axis] = -dInfinity;
        aabb[2 * axis + 1] = dInfinity;
    }
}

// Upstream frees its blocks and leaves the geoms pointing to them: they cannot come into another space of the
// kinds that look at that. Here the other of the two fields that such spaces look at tells it.
dxOrderedQuadTreeSpace::~dxOrderedQuadTreeSpace() {
    for (dxGeom *geom = dxSpace::first; geom != nullptr; geom = geom->next) geom->next_ex = geom;
}

// As upstream, which has none.
dxGeom *dxOrderedQuadTreeSpace::getGeom(int index) {
    dUASSERT(index >= 0 && index < count, "index out of range");
    dDebug(0, "dxQuadTreeSpace::getGeom() not yet implemented");
    return nullptr;
}
