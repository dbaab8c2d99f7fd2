// Arrays in an arena, each aligned to a cache line.
#pragma once

#include <cstddef>

#include "core/dxCacheLine.h"
#include "dynamics/exactstep/dantzig/dxUpstreamLcp.h"

template <class Element>
Element *dxTakeArray(dxWorldProcessMemArena *arena, std::size_t count) {
    return arena->AllocateOveralignedArray<Element>(count, kCacheLine);
}

// Returns its size in the arena.
template <class Element>
std::size_t dxArrayBytes(std::size_t count) {
    return dOVERALIGNED_SIZE(count * sizeof(Element), kCacheLine);
}
