// A space in which upstream walks a list of geoms: the simple and the hash space.
//
// Upstream moves a geom to the front of its list when it changes, and only then. Of two members, the one with the higher
// rank stands further to the front.
#pragma once

#include <climits>
#include <vector>

#include "collision/dxOrderedSpace.h"

class dxOrderedListSpace : public dxOrderedSpace {
public:
    void cleanGeoms() override;

protected:
    using dxOrderedSpace::dxOrderedSpace;

    // Geoms that move from which on testing all pairs, as upstream does, is faster than ranks and pairs are. INT_MAX: never.
    virtual int leastToWalk() const { return INT_MAX; }

    bool requireRanks() override;
    void collideWith(void *data, dxGeom *geom, dNearCallback *callback) override;

private:
    int leastMovedToWalk() const;
    void gatherDirty();
    void cleanAndRank();
    void chooseToWalk();
    void stopWalking();
    void rankBehindClean(dxGeom *geom, dxRank rank);

    std::vector<dxGeom *> m_dirty;  // front first
    int m_moved = 0;                // geoms that were cleaned since ranks were asked for, as many as there are at most
    int m_walks = 0;                // of collide2 since a geom moved
    bool m_isWalked = false;        // as upstream does, for so many move
    bool m_irregular = false;       // ranks do not stand for the list: there are dirty geoms behind clean ones, or it is
                                    // walked
};
