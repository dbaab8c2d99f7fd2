// The simple space, which pairs each geom with those behind it in the list, from the front on; with its order of pairs and its walker.
// docs/collision.md. Threading: as dxOrderedSpace.
#pragma once

#include <cstddef>
#include <vector>

#include "collision/broadphase/dxPairRows.h"
#include "collision/broadphase/overlap/dxBoxColumns.h"
#include "collision/spaces/dxListCleaner.h"
#include "collision/spaces/dxOrderedSpace.h"
#include "collision/spaces/dxSpacePairs.h"

class dxOrderedSimpleSpace final : public dxOrderedSpace {
public:
    explicit dxOrderedSimpleSpace(dSpaceID parent)
        : dxOrderedSpace(parent, dSimpleSpaceClass, dxPairOrder::List, m_cleaner, m_order, m_walker), m_cleaner(geoms()),
          m_order(geoms(), foundPairs()), m_walker(*this, m_cleaner, m_order) {}

    void cleanGeoms() override { m_cleaner.clean(); }
    void collide(void *data, dNearCallback *callback) override;
    void collide2(void *data, dxGeom *geom, dNearCallback *callback) override {
        if (!dxListQuery::collideAll(geoms(), m_cleaner, data, geom, callback)) dxOrderedSpace::collide2(data, geom, callback);
    }

private:
    // Pairs are ordered by rank: of two members the one further to the front is the first; pairs are ordered by the first, then by the second.
    class Order final : public dxRankPairOrder {
    public:
        using dxRankPairOrder::dxRankPairOrder;

        dxPairRows &gatherRows() override;
        dxPairRows &rows() { return m_rows; }

    private:
        dxPairRows m_rows;
    };

    class Walker final : public dxSpaceWalker {
    public:
        Walker(dxOrderedSpace &space, dxListCleaner &cleaner, Order &order) : m_space(space), m_cleaner(cleaner), m_order(order) {}

        void deliver(void *data, dNearCallback *callback) override;
        void deliverAnew(void *data, dNearCallback *callback) override;
        void walk(void *data, dNearCallback *callback, const dxOrderedPair *after) override;
        void collideWith(void *data, dxGeom *geom, dNearCallback *callback) override {
            dxListQuery::collideWith(m_space.geoms(), m_cleaner, data, geom, callback);
        }
        // Executes upstream's tests from the pair of these geoms on; `g1` NULL: from the first pair of the space on.
        void walkFrom(dxGeom *g1, dxGeom *g2, void *data, dNearCallback *callback);

    private:
        bool walkRows(void *data, dNearCallback *callback);
        bool findListed();
        bool areBoxesUpToDate() const;

        dxOrderedSpace &m_space;
        dxListCleaner &m_cleaner;
        Order &m_order;
        // Scratch of a walk of a small space: the geoms in the order of the list, their boxes, overlaps and pairs.
        std::vector<dxGeom *> m_listed;
        dxBoxColumns m_boxes;
        std::vector<dxSlotPair> m_overlaps;
        std::vector<dxOrderedPair> m_walked;
        std::size_t m_overlapsWalked = 0;  // number of overlaps in the last walk with SIMD
    };

    dxListCleaner m_cleaner;
    Order m_order;
    Walker m_walker;
};
