// The random numbers that the island draws which the calling thread steps: its own part of the sequence, if the scope of the thread
// has one (dxDeferredScope, dxReservedDraws), or the next of the process.
#pragma once

#include <cstdint>

// Returns the seed before the first of them.
std::uint32_t dxTakeIslandDraws(std::uint64_t draws);

// dRandInt, as upstream's QuickStep calls it.
extern "C" int dxDrawForIsland(int range);
