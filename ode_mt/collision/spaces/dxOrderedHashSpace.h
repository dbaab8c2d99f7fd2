// The hash space: each geom finds others in the cells that it covers, on its own level and those above; pairs with
// geoms too large for any level follow. docs/collision-order.md.
#pragma once

#include <vector>

#include "collision/spaces/dxHashCells.h"
#include "collision/spaces/dxHashRows.h"
#include "collision/spaces/dxOrderedListSpace.h"

class dxOrderedHashSpace final : public dxOrderedListSpace {
public:
    explicit dxOrderedHashSpace(dSpaceID parent) : dxOrderedListSpace(parent, dHashSpaceClass, dxPairOrder::Cells) {}

    void setLevels(const dxHashLevels &levels);
    const dxHashLevels &levels() const { return m_levels; }

    void collide(void *data, dNearCallback *callback) override;
    bool findPairs() override;

private:
    dxPairRows &gatherRows() override;
    void deliverAnew(void *data, dNearCallback *callback) override;
    void update(std::vector<dxOrderedPair> &pairs, dxPairWork &work) override;
    bool primaryKey(Slot a, Slot b, std::uint64_t &word, bool &swapped) const override;
    bool secondaryKey(Slot first, Slot second, dxPairKey &key) const override;
    void prefetch(Slot slot) const override;
    void deliver(void *data, dNearCallback *callback) override;
    void walk(void *data, dNearCallback *callback, const dxOrderedPair *after) override;

    void updateCells();
    int updateCellsOf(Slot slot);
    void requireInRange() const;

    dxHashLevels m_levels{-3, 10};              // upstream's defaults
    bool m_levelsChanged = false;               // since pairs() was brought up to date
    std::vector<dxHashCells> m_cells;           // by slot; none: the member was not enabled when the outermost call began
    int m_outOfRange = 0;                       // number of members of this kind
    dxHashRows m_rows;
};
