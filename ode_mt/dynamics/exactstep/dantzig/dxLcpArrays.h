// Arrays in an arena, each from the start of a line of the cache on.
#pragma once

#include <cstddef>

#include "core/dxCacheLine.h"
#include "dynamics/exactstep/dantzig/dxUpstreamLcp.h"

template <class Element>
Element *dxTakeArray(dxWorldProcessMemArena *arena, std::size_t count) {
    return arena->AllocateOveralignedArray<Element>(count, kCacheLine);
}

// What it takes of the arena.
template <class Element>
std::size_t dxArrayBytes(std::size_t count) {
    return dOVERALIGNED_SIZE(count * sizeof(Element), kCacheLine);
}
