// Prefetches what a near-callback and its colliders read of a pair: in the order of pairs, geoms are at random places in memory, and a large scene
// does not fit L2. There are two steps, because a geom refers to its pose by a pointer. Threading: thread-safe while the pairs stay.
#pragma once

#include <vector>

#include "collision/pairs/dxPair.h"
#include "core/dxPrefetch.h"

#include "config.h"
#include "objects.h"
#include "collision_kernel.h"

namespace dxPairPrefetch {

constexpr std::size_t kGeomPrefetchDistance = 8, kPosePrefetchDistance = 4;  // pairs

inline void geom(const dxGeom *geom) { dxPrefetch::lines(geom, sizeof(dxGeom) + 4 * sizeof(dReal)); }

inline void pose(const dxGeom *geom) {
    if (geom->final_posr != nullptr) dxPrefetch::lines(geom->final_posr, sizeof(dxPosR));
}

// Prefetches for the narrow phase during the work on pairs[index].
inline void forNarrowphase(const std::vector<dxOrderedPair> &pairs, std::size_t index) {
    if (index + kGeomPrefetchDistance < pairs.size()) {
        const dxOrderedPair &pair = pairs[index + kGeomPrefetchDistance];
        geom(pair.first);
        geom(pair.second);
    }
    if (index + kPosePrefetchDistance < pairs.size()) {
        const dxOrderedPair &pair = pairs[index + kPosePrefetchDistance];
        pose(pair.first);
        pose(pair.second);
    }
}

// The same on the thread of the callbacks, with the joint lists of both bodies, into which a contact joint is inserted.
inline void forCallback(const std::vector<dxOrderedPair> &pairs, std::size_t index) {
    forNarrowphase(pairs, index);
    if (index + kPosePrefetchDistance >= pairs.size()) return;
    const dxOrderedPair &pair = pairs[index + kPosePrefetchDistance];
    for (const dxGeom *const geom : {pair.first, pair.second})
        if (geom->body != nullptr) dxPrefetch::lineForWrite(&geom->body->firstjoint);
}

}  // namespace dxPairPrefetch
