// The hash space: each geom finds others in the cells that it covers, on its own level and those above; pairs with
// geoms too large for any level follow. docs/collision.md.
#pragma once

#include <vector>

#include "collision/spaces/dxHashCells.h"
#include "collision/spaces/dxHashRows.h"
#include "collision/spaces/dxListCleaner.h"
#include "collision/spaces/dxOrderedSpace.h"

// The order of pairs by cells.
class dxCellPairOrder final : public dxSpacePairOrder {
public:
    using Slot = dxMembers::Slot;

    dxCellPairOrder(dxSpaceGeoms &geoms, dxSpacePairs &pairs) : m_geoms(geoms), m_pairs(pairs) {}

    // Upstream takes them at its next call, and a callback may set them: pairs stay as they are until then.
    void setLevels(const dxHashLevels &levels) {
        m_levels = levels;
        m_pairs.outdate();
    }
    const dxHashLevels &levels() const { return m_levels; }
    // Returns the cells of a member as of the last call.
    const dxHashCells &cellsOf(Slot slot) const { return m_cells[slot]; }
    dxHashRows &rows() { return m_rows; }

    void update(std::vector<dxOrderedPair> &pairs, dxPairWork &work) override;
    dxPairRows &gatherRows() override;
    // No enabled geom is out of range.
    bool requireValid() const override;

    bool primaryKey(Slot a, Slot b, std::uint64_t &word, bool &swapped) const override;
    bool secondaryKey(Slot first, Slot second, dxPairKey &key) const override;
    void prefetch(Slot slot) const override;

private:
    void updateCells();
    int updateCellsOf(Slot slot);

    dxSpaceGeoms &m_geoms;
    dxSpacePairs &m_pairs;
    dxHashLevels m_levels{-3, 10};     // upstream's defaults
    std::vector<dxHashCells> m_cells;  // by slot; none: the member was not enabled when the outermost call began
    int m_outOfRange = 0;              // number of members of this kind
    dxHashRows m_rows;
};

class dxCellWalker final : public dxSpaceWalker {
public:
    dxCellWalker(dxOrderedSpace &space, dxListCleaner &cleaner, dxCellPairOrder &order) : m_space(space), m_cleaner(cleaner), m_order(order) {}

    void deliver(void *data, dNearCallback *callback) override;
    void deliverAnew(void *data, dNearCallback *callback) override;
    void walk(void *data, dNearCallback *callback, const dxOrderedPair *after) override;
    void collideWith(void *data, dxGeom *geom, dNearCallback *callback) override {
        dxListQuery::collideWith(m_space.geoms(), m_cleaner, data, geom, callback);
    }

private:
    dxOrderedSpace &m_space;
    dxListCleaner &m_cleaner;
    dxCellPairOrder &m_order;
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
    dxCellPairOrder m_order;
    dxCellWalker m_walker;
};
