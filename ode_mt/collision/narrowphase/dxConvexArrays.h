// Copies of the arrays of convex geoms, for workers to read.
//
// Points, planes and polygons are the program's; it may write to them, or free those of a geom that it does not collide
// any more, without a notification. They exist whenever it calls dCollide for the geom: only then are they
// read, and copied if they have changed. Workers prefetch contacts (dxNarrowphasePrefetch) from the copy. Such contacts are
// valid as long as the geom's arrays are equal to the copy.
//
// Threading: one thread at a time; while workers read, no thread changes anything. Dropped: a hash of the program's
// arrays, taken by workers. They read freed arrays.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

#include <ode/ode.h>

#include "collision/pairs/dxMembers.h"

struct dxConvex;

class dxConvexArrays {
public:
    using Slot = dxMembers::Slot;

    // One set of arrays, never changed. Geoms that were given the same arrays share a copy.
    class Copy {
    public:
        // Throws std::bad_alloc.
        explicit Copy(const dxConvex &convex);

        std::uint64_t number() const { return m_number; }  // unique, never 0
        bool equals(const dxConvex &convex) const;
        // Sets these arrays in a copy of the geom, which may have been given longer ones.
        void giveTo(dxConvex &convex) const;

    private:
        const std::uint64_t m_number;
        std::vector<dReal> m_planes, m_points;
        std::vector<unsigned> m_polygons;
    };

    // Requires a call when the program collides the geom. Without memory the geom has no copy.
    void read(Slot slot, const dxConvex &convex);
    void forget(Slot slot);

    // Returns the copy; NULL: the geom has not been collided.
    const Copy *of(Slot slot) const { return slot < m_copies.size() ? m_copies[slot].get() : nullptr; }

private:
    // Addresses and lengths of the program's arrays: planes, points, polygons; numbers of planes and points.
    using Place = std::tuple<const void *, const void *, const void *, unsigned, unsigned>;

    std::shared_ptr<const Copy> copyOf(const dxConvex &convex);
    void dropUnused();

    std::vector<std::shared_ptr<const Copy>> m_copies;  // by slot
    std::map<Place, std::weak_ptr<const Copy>> m_byPlace;
    std::size_t m_maxPlaces = 64;  // number of entries at which those that no geom has are dropped
};
