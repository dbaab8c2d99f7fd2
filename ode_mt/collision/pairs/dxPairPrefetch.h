// Asks the memory for what a near-callback and its colliders are about to read of a pair: geoms in their order of
// pairs lie anywhere, and a large scene does not fit a cache close to the core.
//
// In two steps, because where a geom stands is behind a pointer in it.
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

// While pairs[index] is worked on.
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

// The same on the thread that calls back: a contact joint is put into the lists of both bodies.
inline void aheadOfCallback(const std::vector<dxOrderedPair> &pairs, std::size_t index) {
    ahead(pairs, index);
    if (index + kPlacesAhead >= pairs.size()) return;
    const dxOrderedPair &pair = pairs[index + kPlacesAhead];
    for (const dxGeom *const geom : {pair.first, pair.second})
        if (geom->body != nullptr) dxFetch::lineToWrite(&geom->body->firstjoint);
}

}  // namespace dxPairPrefetch
