// Packs that are solved one after the other: which manifold is in which lane of which pack.
//
// A manifold comes after those before it that act on its bodies, so that a sweep carries a load through a stack from one end to
// the other, as a sweep over rows in upstream's order does. Colours would carry it from one contact to the next, and high stacks
// then fall (docs/iterative-solver.md, "One after the other").
//
// Source of the method: Hu, "Parallel sequencing and assembly line problems", Operations Research 9, 1961 (unit tasks by level, eight at once).
#pragma once

#include <cstdint>
#include <vector>

#include "dynamics/iterative/dxContactManifold.h"

class dxPackOrder {
public:
    // Sets packs and lanes of all manifolds, `turns` being their indices in the order in which they are solved. `moves`: by body. Returns the
    // number of packs. Throws std::bad_alloc.
    unsigned place(std::vector<dxContactManifold> &manifolds, const std::vector<unsigned> &turns, const std::vector<std::uint8_t> &moves);

    // Takes as much memory as another one has. Throws std::bad_alloc.
    void reserveAs(const dxPackOrder &other);

private:
    unsigned findLevels(const std::vector<dxContactManifold> &manifolds, const std::vector<unsigned> &turns,
                        const std::vector<std::uint8_t> &moves);
    void sortByLevel(const std::vector<dxContactManifold> &manifolds, unsigned levels);

    std::vector<unsigned> m_end;        // by body: of what has been placed, the level or pack after the last one that acts on it
    std::vector<unsigned> m_level;      // by manifold
    std::vector<unsigned> m_firstOf;    // by level and number of contacts
    std::vector<unsigned> m_sequence;   // manifolds by level
    std::vector<std::uint8_t> m_lanes;  // by pack: how many are taken
};
