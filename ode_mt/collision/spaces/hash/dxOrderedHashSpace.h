// The hash space, and its callbacks (dxHashWalker). docs/collision.md. Threading: as dxOrderedSpace.
#pragma once

#include "collision/spaces/dxListCleaner.h"
#include "collision/spaces/dxOrderedSpace.h"
#include "collision/spaces/hash/dxHashPairOrder.h"

class dxHashWalker final : public dxSpaceWalker {
public:
    dxHashWalker(dxOrderedSpace &space, dxListCleaner &cleaner, dxHashPairOrder &order) : m_space(space), m_cleaner(cleaner), m_order(order) {}

    void deliver(void *data, dNearCallback *callback) override;
    void deliverAnew(void *data, dNearCallback *callback) override;
    void walk(void *data, dNearCallback *callback, const dxOrderedPair *after) override;
    void collideWith(void *data, dxGeom *geom, dNearCallback *callback) override {
        dxListQuery::collideWith(m_space.geoms(), m_cleaner, data, geom, callback);
    }

private:
    dxOrderedSpace &m_space;
    dxListCleaner &m_cleaner;
    dxHashPairOrder &m_order;
};

class dxOrderedHashSpace final : public dxOrderedSpace {
public:
    explicit dxOrderedHashSpace(dSpaceID parent)
        : dxOrderedSpace(parent, dHashSpaceClass, dxPairOrder::Cells, m_cleaner, m_order, m_walker), m_cleaner(geoms()),
          m_order(geoms(), foundPairs()), m_walker(*this, m_cleaner, m_order) {}

    void setLevels(const dxHashLevels &levels) { m_order.setLevels(levels); }
    const dxHashLevels &levels() const { return m_order.levels(); }

    void cleanGeoms() override { m_cleaner.clean(); }
    void collide(void *data, dNearCallback *callback) override;
    void collide2(void *data, dxGeom *geom, dNearCallback *callback) override {
        if (!dxListQuery::collideAll(geoms(), m_cleaner, data, geom, callback)) dxOrderedSpace::collide2(data, geom, callback);
    }

private:
    dxListCleaner m_cleaner;
    dxHashPairOrder m_order;
    dxHashWalker m_walker;
};
