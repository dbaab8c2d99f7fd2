// The sweep-and-prune (SAP) space, and its callbacks (dxSapWalker). docs/collision.md. Threading: as dxOrderedSpace.
#pragma once

#include <cstddef>
#include <vector>

#include "collision/spaces/dxOrderedSpace.h"
#include "collision/spaces/sweep_and_prune/dxSapCleaner.h"
#include "collision/spaces/sweep_and_prune/dxSapPairOrder.h"
#include "collision/spaces/sweep_and_prune/dxSapState.h"
#include "collision/spaces/sweep_and_prune/dxSapWalk.h"

class dxSapWalker final : public dxSpaceWalker {
public:
    using Slot = dxMembers::Slot;

    dxSapWalker(dxOrderedSpace &space, dxSapState &state, dxSapLastWalk &lastWalk, dxSapCleaner &cleaner, dxSapPairOrder &order)
        : m_space(space), m_state(state), m_lastWalk(lastWalk), m_cleaner(cleaner), m_order(order) {}

    void deliver(void *data, dNearCallback *callback) override;
    void deliverAnew(void *data, dNearCallback *callback) override;
    void walk(void *data, dNearCallback *callback, const dxOrderedPair *after) override;
    void collideWith(void *data, dxGeom *geom, dNearCallback *callback) override;

    // Executes upstream's collide2 from a place among the clean members on.
    void collideFrom(std::size_t place, void *data, dxGeom *geom, dNearCallback *callback);

private:
    void deliverBehind(const dxOrderedPair &after, unsigned fills, void *data, dNearCallback *callback);
    void fillLists(const dxSapWalk &walk);
    std::vector<dxGeom *> geomsIn(const std::vector<Slot> &slots) const;
    void findPairsOf(dxSapWalk &walk);

    dxOrderedSpace &m_space;
    dxSapState &m_state;
    dxSapLastWalk &m_lastWalk;
    dxSapCleaner &m_cleaner;
    dxSapPairOrder &m_order;
};

class dxOrderedSapSpace final : public dxOrderedSpace {
public:
    // `axes`: dSAP_AXES_XYZ and so on, or any number.
    dxOrderedSapSpace(dSpaceID parent, int axes);
    ~dxOrderedSapSpace() override;

    dxGeom *getGeom(int i) override;
    void dirty(dxGeom *geom) override { m_cleaner.makeDirty(geom); }
    void computeAABB() override {}  // it is infinite
    void cleanGeoms() override { m_cleaner.clean(); }
    void collide2(void *data, dxGeom *geom, dNearCallback *callback) override;

private:
    dxSapState m_state;
    dxSapLastWalk m_lastWalk;
    dxSapCleaner m_cleaner;
    dxSapPairOrder m_order;
    dxSapWalker m_walker;
};
