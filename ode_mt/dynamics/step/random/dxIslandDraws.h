// The random numbers of the island that the calling thread steps: from its own part of the sequence, if the scope of the thread
// has one (dxDeferredScope, dxReservedDraws), or else the next of the process.
//
// Threading: any thread that steps islands.
#pragma once

#include <cstdint>

#include "threading/dxUpstreamScope.h"

// Takes random numbers. Returns the seed before the first of them.
std::uint32_t dxTakeIslandDraws(std::uint64_t draws);

// dRandInt, as upstream's QuickStep calls it.
extern "C" int dxDrawForIsland(int range);

// The scope of islands that are stepped in order on the calling thread: their random numbers were taken from the shared
// sequence as one block beforehand, so that a step of another thread cannot interleave (contract C7).
//
// Before user code can read the shared sequence, the unused rest of the block is given back, and the islands that follow
// draw one by one, as upstream does. If another thread has drawn meanwhile, nothing can be given back, and the next
// numbers follow those of that thread.
class dxReservedDraws final : public dxUpstreamScope {
public:
    // `seed`: the sequence before the next draw; `end`: after the last reserved one.
    dxReservedDraws(std::uint32_t seed, std::uint32_t end) : m_seed(seed), m_end(end) {}

    std::uint32_t takeBlock(std::uint64_t draws) override;
    bool defersMoved() const override { return false; }
    bool takeOver(dxReport kind, int number, const char *format, va_list arguments) override;

    void giveBack();

private:
    std::uint32_t m_seed;
    std::uint32_t m_end;
    bool m_givenBack = false;
};
