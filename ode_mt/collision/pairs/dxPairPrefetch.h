// Prefetches what a near-callback and its colliders read of a pair: in the order of pairs, geoms are random in memory,
// and a large scene does not fit L2.
//
// There are two steps, because a geom refers to its pose by a pointer.
#pragma once

#include <vector>

#include "collision/pairs/dxOrderedPair.h"
#include "core/dxFetch.h"

#include "config.h"
#include "objects.h"
#include "collision_kernel.h"

namespace dxPairPrefetch {

constexpr std::size_t kGeomsAhead = 8, kPlacesAhead = 4;  // pairs

inline void geom(const dxGeom *geom) { dxFetch::lines(geom, sizeof(dxGeom) + 4 * sizeof(dReal)); }

inline void place(const dxGeom *geom) {
    if (geom->final_posr != nullptr) dxFetch::lines(geom->final_posr, sizeof(dxPosR));
}

// Prefetches for the narrow phase during the work on pairs[index].
inline void ahead(const std::vector<dxOrderedPair> &pairs, std::size_t index) {
    if (index + kGeomsAhead < pairs.size()) {
        const dxOrderedPair &pair = pairs[index + kGeomsAhead];
        geom(pair.first);
        geom(pair.second);
    }
    if (index + kPlacesAhead < pairs.size()) {
        const dxOrderedPair &pair = pairs[index + kPlacesAhead];
        place(pair.first);
        place(pair.second);
    }
}

// The same on the thread of the callbacks, with the joint lists of both bodies, into which a contact joint is inserted.
inline void aheadOfCallback(const std::vector<dxOrderedPair> &pairs, std::size_t index) {
    ahead(pairs, index);
    if (index + kPlacesAhead >= pairs.size()) return;
    const dxOrderedPair &pair = pairs[index + kPlacesAhead];
    for (const dxGeom *const geom : {pair.first, pair.second})
        if (geom->body != nullptr) dxFetch::lineToWrite(&geom->body->firstjoint);
}

}  // namespace dxPairPrefetch
