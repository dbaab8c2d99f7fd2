// The memory of a run of Dantzig's algorithm (dxDantzigRun), beside the order of its rows and the factor: arrays in an arena, each aligned to a cache
// line.
#pragma once

#include <cstddef>

#include "core/dxCacheLine.h"
#include "dynamics/world_step/exact/dxUpstreamLcp.h"
#include "dynamics/world_step/kernels/dxMaximumStep.h"

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

struct dxDantzigArrays {
    // For n rows, of which the first `bilateral` are bilateral rows.
    static dxDantzigArrays take(dxWorldProcessMemArena *arena, unsigned n, unsigned bilateral);

    // The most that `take` needs, in bytes.
    static std::size_t memory(unsigned n);

    dReal *matrix;                  // of dxLcpMatrix
    unsigned *sets;                 // of dxIndexSets
    dReal **factorRows;             // L, by row
    dReal *diagonal;                // 1/D
    unsigned *begins;               // of the rows of L
    dReal *solutions;               // of dxForwardSolves
    unsigned *solutionWords;

    // By row, in the run's order.
    dReal *b, *x, *w, *deltaW;
    dxLimitPair *limits;
    dReal *side;           // for rows of N: the sign that w may have, 0 where the limits leave no room for x
    unsigned *leaving;     // positions in N of the rows that leave their side: a list of findDeltaW

    unsigned *halfBlockN;  // rows of N in each half of a block of lanes; 0
    dReal *deltaX;         // by position in C

    // In the order of the factorisation, for the column i that was asked for last.
    dReal *solved;     // L^-1 A(C,i)
    dReal *temporary;  // from findFactorColumn to findDeltaX: D^-1 L^-1 A(C,i)

private:
    dxDantzigArrays(dxArrayTaker &taker, unsigned n, unsigned bilateral);
};
