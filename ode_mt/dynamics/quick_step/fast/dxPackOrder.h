// Packs that are solved one after the other: which manifold is in which lane of which pack.
//
// Manifolds are sorted by their level, which counts the bodies between them and what does not move, and are taken upwards or downwards, so that a
// sweep carries a load through a stack from one end to the other. Colours would carry it from one contact to the next only, and high stacks then
// fall (docs/fast.md, "The order of packs"). Each manifold of a level goes into the first pack that is free on both of its bodies,
// after all packs that earlier levels have on them.
//
// Source of the method: Hu, "Parallel sequencing and assembly line problems", Operations Research 9, 1961 (unit tasks by level, eight at once).
#pragma once

#include <cstdint>

#include "core/dxStepArena.h"
#include "dynamics/quick_step/fast/dxContactPack.h"

struct dxPackCount {
    std::size_t packs, contacts;  // contacts: of each pack the number of contacts of its largest manifold
};

// `body`: a tag, or dxContactPack::kNoBody; `moves`: by tag.
inline bool dxDoesMove(int body, dxArenaArray<const std::uint8_t> moves) {
    return body != dxContactPack::kNoBody && moves[static_cast<unsigned>(body)] != 0;
}

// Sets packs and lanes of all manifolds that may be lanes. By body: `moves`; `goesDown`: its island is solved from the top. Throws std::bad_alloc.
dxPackCount dxOrderPacks(dxArenaArray<dxContactManifold> manifolds, dxArenaArray<const std::uint8_t> moves,
                         dxArenaArray<const std::uint8_t> goesDown, dxStepArena &arena);
