#include "collision/spaces/dxOrderedSapSpace.h"

#include "collision/spaces/dxGeomQuery.h"

#include "collision_space_internal.h"
#include "util.h"

// If the axes are not all three, upstream's sweep meets pairs that do not overlap: then no broad phase can find them.
dxOrderedSapSpace::dxOrderedSapSpace(dSpaceID parent, int axes)
    : dxOrderedSpace(parent, dSweepAndPruneSpaceClass, dxPairOrder::Axis, m_cleaner, m_order, m_walker, dxSapAxes(axes).areAll()), m_state(axes),
      m_cleaner(geoms(), foundPairs(), m_state), m_order(geoms(), foundPairs(), m_state, m_cleaner.lists()),
      m_walker(*this, m_state, m_cleaner, m_order) {
    dInfiniteAABB(this, aabb);
}

// Geoms go from the front of the two lists, as upstream's do, whatever a geom's destructor of the user's
// moves, adds or destroys on the way. What that has made dirty behind the first list is left to the
// destructors below.
dxOrderedSapSpace::~dxOrderedSapSpace() {
    dxSapWalk::requireUnlocked(*this);
    const auto empty = [this](const std::vector<dxSapLists::Entry> &list) {
        while (!list.empty()) {
            if (cleanup)
                dGeomDestroy(list.front().geom);
            else
                remove(list.front().geom);
        }
    };
    empty(m_cleaner.lists().dirty());
    empty(m_cleaner.lists().clean());
}

dxGeom *dxOrderedSapSpace::getGeom(int i) {
    dUASSERT(i >= 0 && i < count, "index out of range");
    const dxSapLists &lists = m_cleaner.lists();
    const auto at = static_cast<std::size_t>(i), dirtyOnes = lists.dirty().size();
    return at < dirtyOnes ? lists.dirty()[at].geom : lists.clean()[at - dirtyOnes].geom;
}

// As upstream, whatever is known of the members.
void dxOrderedSapSpace::collide2(void *data, dxGeom *geom, dNearCallback *callback) {
    if (geoms().isWorthAnIndex() || !m_cleaner.lists().dirty().empty()) return dxOrderedSpace::collide2(data, geom, callback);
    dxCollideClean(geoms(), geom, callback, [&] { m_walker.collideFrom(0, data, geom, callback); });
}
