// The callbacks of sweep-and-prune spaces. Threading: as dxOrderedSpace.
#pragma once

#include <cstddef>
#include <vector>

#include "collision/spaces/dxOrderedSpace.h"
#include "collision/spaces/dxSapCleaner.h"
#include "collision/spaces/dxSapPairOrder.h"
#include "collision/spaces/dxSapState.h"

class dxSapWalker final : public dxSpaceWalker {
public:
    using Slot = dxMembers::Slot;

    dxSapWalker(dxOrderedSpace &space, dxSapState &state, dxSapCleaner &cleaner, dxSapPairOrder &order)
        : m_space(space), m_state(state), m_cleaner(cleaner), m_order(order) {}

    void deliver(void *data, dNearCallback *callback) override;
    void deliverAnew(void *data, dNearCallback *callback) override;
    void walk(void *data, dNearCallback *callback, const dxOrderedPair *after) override;
    void collideWith(void *data, dxGeom *geom, dNearCallback *callback) override;

    // As upstream's collide2, from a place among the clean members on.
    void collideFrom(std::size_t place, void *data, dxGeom *geom, dNearCallback *callback);

private:
    void deliverBehind(const dxOrderedPair &after, unsigned fills, void *data, dNearCallback *callback);
    void fillTemporary(const dxSapWalk &walk);
    std::vector<dxGeom *> geomsIn(const std::vector<Slot> &slots) const;
    void findPairsOf(dxSapWalk &sweep);

    dxOrderedSpace &m_space;
    dxSapState &m_state;
    dxSapCleaner &m_cleaner;
    dxSapPairOrder &m_order;
};
