// Arrays in an arena, each aligned to a cache line.
#pragma once

#include <cstddef>

#include "core/dxCacheLine.h"
#include "dynamics/world_step/exact/dantzig/dxUpstreamLcp.h"

template <class Element>
Element *dxTakeArray(dxWorldProcessMemArena *arena, std::size_t count) {
    return arena->AllocateOveralignedArray<Element>(count, kCacheLine);
}

// Returns its size in the arena.
template <class Element>
std::size_t dxArrayBytes(std::size_t count) {
    return dOVERALIGNED_SIZE(count * sizeof(Element), kCacheLine);
}

// Takes arrays one after another, or, without an arena, adds up their sizes: so one list of arrays says both what is taken and how
// much that is.
class dxArrayTaker {
public:
    explicit dxArrayTaker(dxWorldProcessMemArena *arena = nullptr) : m_arena(arena) {}

    template <class Element>
    Element *take(std::size_t count) {
        m_bytes += dxArrayBytes<Element>(count);
        return m_arena != nullptr ? dxTakeArray<Element>(m_arena, count) : nullptr;
    }

    std::size_t bytes() const { return m_bytes; }

private:
    dxWorldProcessMemArena *const m_arena;
    std::size_t m_bytes = 0;
};
