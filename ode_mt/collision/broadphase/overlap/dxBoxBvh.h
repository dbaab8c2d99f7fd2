// A bounding volume hierarchy (BVH) of resting boxes, eight to a node, which are tested with SIMD.
//
// Boxes are rows, given in an order in which neighbours in space tend to be neighbours in the table. Eight
// consecutive rows make a node, eight nodes one of the next level, and so on. Where a row lies follows from
// its number, so there are no pointers. Source of the idea: packed R-trees (Kamel and Faloutsos, On Packing
// R-trees, 1993).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <vector>

#include "core/dxBounds.h"

class dxBoxBvh {
public:
    // Builds the tree row by row. Requires proper boxes (dxBounds::isProper).
    void begin();
    void push(const dxBounds &box);
    void finish();

    // Removes a row from the results.
    void erase(std::size_t row);

    // Appends the rows whose boxes overlap `box`, any box, by dxBounds::overlaps. The order is unspecified. Several
    // threads may query.
    void query(const dxBounds &box, std::pmr::vector<std::uint32_t> &rows) const;

    struct Level {
        std::vector<double>
            bounds[6];  // padded to whole nodes with boxes that overlap no finite box
        std::size_t size() const { return bounds[0].size(); }
        void push(const double *box);
        void fillUp();
    };

private:
    std::vector<Level> m_levels;  // rows first, the last one is a single node
    // By row. An infinite box overlaps even the padding.
    std::vector<std::uint8_t> m_isThere;
    std::size_t m_inUse = 0;  // levels
};
