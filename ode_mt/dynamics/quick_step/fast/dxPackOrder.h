// Packs that are solved one after the other: which manifold is in which lane of which pack.
//
// Manifolds are sorted by how many bodies lie between them and what does not move, and go up or down, so that a sweep carries a load through a stack from one end to
// the other. Colours would carry it from one contact to the next, and high stacks then fall (docs/iterative-solver.md, "One after the other").
// Those of one level go into the first packs that are free on both bodies, after all packs of levels before.
//
// Source of the method: Hu, "Parallel sequencing and assembly line problems", Operations Research 9, 1961 (unit tasks by level, eight at once).
#pragma once

#include <cstdint>
#include <vector>

#include "dynamics/quick_step/fast/dxContactManifold.h"

class dxPackOrder {
public:
    // Sets packs and lanes of all manifolds. By body: `moves`; `goesDown`: its island is solved from the top. Returns the number of packs. Throws
    // std::bad_alloc.
    unsigned place(std::vector<dxContactManifold> &manifolds, const std::vector<std::uint8_t> &moves, const std::vector<std::uint8_t> &goesDown);

    // Takes as much memory as another one has. Throws std::bad_alloc.
    void reserveAs(const dxPackOrder &other);

private:
    // Packs that act on a body: those before `end`, and bits of `used` for some of this level from `base` on.
    struct Body {
        unsigned end, level, base;
        std::uint64_t used;

        void enter(unsigned newLevel, unsigned firstOpen);
        bool isUsed(unsigned pack) const { return pack < end || (pack - base < 64 && (used >> (pack - base) & 1) != 0); }
        void use(unsigned pack);
    };

    void linkBodies(const std::vector<dxContactManifold> &manifolds, const std::vector<std::uint8_t> &moves);
    void findDepths(const std::vector<dxContactManifold> &manifolds, const std::vector<std::uint8_t> &moves);
    void spreadFrom(unsigned body);
    unsigned findLevels(const std::vector<dxContactManifold> &manifolds, const std::vector<std::uint8_t> &moves,
                        const std::vector<std::uint8_t> &goesDown);
    void sortByLevel(const std::vector<dxContactManifold> &manifolds, unsigned levels);
    template <class IsUsed>
    unsigned findPack(unsigned firstOpen, const IsUsed &isUsed);

    std::vector<unsigned> m_firstLink, m_links;  // by body, and the end; bodies that touch it
    std::vector<unsigned> m_depth, m_reached;    // by body; bodies in the order in which they were found
    std::vector<unsigned> m_level;               // by manifold
    std::vector<unsigned> m_firstOf;             // by level and number of contacts
    std::vector<unsigned> m_sequence;            // manifolds by level
    std::vector<Body> m_bodies;
    std::vector<std::uint8_t> m_lanes;  // by pack: how many are taken
};
