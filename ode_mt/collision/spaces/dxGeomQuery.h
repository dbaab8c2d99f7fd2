// One geom against the members of a space (dSpaceCollide2), in the order of upstream's collide2: all members one by one, or those that an index
// finds. Threading: as dxOrderedSpace.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory_resource>
#include <vector>

#include <ode/ode.h>

#include "collision/spaces/dxPairDelivery.h"
#include "collision/spaces/dxSpaceGeoms.h"
#include "core/dxBounds.h"

#include "util.h"

// Tests a geom against members one by one. Callbacks may move the geom.
class dxGeomQuery {
public:
    dxGeomQuery(void *data, dxGeom *geom, dNearCallback *callback) : m_data(data), m_geom(geom), m_callback(callback) {}

    // Returns the number of members met.
    std::size_t met() const { return m_met; }
    void meet(dxGeom *member) {
        const bool isReady = (member->gflags & (GEOM_ENABLE_TEST_MASK | GEOM_AABB_BAD)) == GEOM_ENABLE_TEST_VALUE;
        if (isReady && !m_probe.overlaps(member->aabb)) return;
        if (!dxGeomIsEnabled(member)) return;
        ++m_met;
        dxCollideBoxes(member, m_geom, m_data, m_callback);
        m_probe = probeOf(m_geom);
    }

private:
    // While the geom's box is not up to date, upstream's assertion fails at the next pair, whether or not the boxes overlap.
    static dxBoxProbe probeOf(const dxGeom *geom) {
        return (geom->gflags & GEOM_AABB_BAD) == 0 ? dxBoxProbe(geom->aabb) : dxBoxProbe::ofAny();
    }

    void *m_data;
    dxGeom *m_geom;
    dNearCallback *m_callback;
    dxBoxProbe m_probe = probeOf(m_geom);
    std::size_t m_met = 0;
};

// The members whose boxes overlap a box, front first, in memory of the caller.
class dxSpaceRegion {
public:
    using Slot = dxMembers::Slot;

    dxSpaceRegion(dxSpaceGeoms &geoms, const dxBounds &box) {
        m_slots.reserve(kOnStack);
        geoms.index().find(geoms.members(), box, m_slots);
        geoms.noteMet(m_slots.size());
    }
    dxSpaceRegion(const dxSpaceRegion &) = delete;
    dxSpaceRegion &operator=(const dxSpaceRegion &) = delete;

    const std::pmr::vector<Slot> &slots() const { return m_slots; }

private:
    // A callback may leave by longjmp: memory on the stack needs no release.
    static constexpr std::size_t kOnStack = 512;

    alignas(std::max_align_t) std::byte m_buffer[kOnStack * sizeof(Slot)];
    std::pmr::monotonic_buffer_resource m_memory{m_buffer, sizeof m_buffer};
    std::pmr::vector<Slot> m_slots{&m_memory};
};

// Returns whether the geom's box is still `box`. A geom that is not in the space may move in a callback.
inline bool dxHasKeptBox(const dxGeom *geom, const dxBounds &box) {
    return (geom->gflags & GEOM_AABB_BAD) == 0 && std::memcmp(geom->aabb, box.v, sizeof box.v) == 0;
}

// Executes collide2() of a clean space whose members are all compared, by collideAll(). It omits what would take longer than comparing a few members.
template <class CollideAll>
void dxCollideClean(dxSpaceGeoms &geoms, dxGeom *geom, dNearCallback *callback, const CollideAll &collideAll) {
    dAASSERT(geom && callback);
    geoms.lock();
    geom->recomputeAABB();
    collideAll();
    geoms.unlock();
}

// Executes upstream's collide2, where it walks a list that has the order of ranks, for the members that the index finds. Returns NULL, or the member
// in whose callback the geom moved: upstream continues behind it with the new box. (Members cannot move while the space is locked.)
inline dxGeom *dxCollideRegion(dxSpaceGeoms &geoms, void *data, dxGeom *geom, dNearCallback *callback) {
    const dxBounds box(geom->aabb);
    const dxSpaceRegion region = geoms.beforeCallbacks([&] { return dxSpaceRegion(geoms, box); });
    const std::uint64_t missed = dxMissedNotifications.count();
    for (const dxMembers::Slot slot : region.slots()) {
        dxGeom *const member = geoms.members().geomIn(slot);
        if (!dxGeomIsEnabled(member)) continue;
        dxCollideBoxes(member, geom, data, callback);
        if (!dxHasKeptBox(geom, box) || dxMissedNotifications.count() != missed) return member;
    }
    return nullptr;
}
