// Solves packed problems: a pure function of their bytes. What a worker does.
//
// Threading: any thread, one problem at a time; the thread's floating-point environment is the problem's meanwhile.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "remote/transport/dxRemoteFrame.h"

// A problem that cannot be solved (no memory, no problem, an error that upstream reports otherwise than by a message) is given back. Throws
// std::bad_alloc where not even that can be said.
void dxSolvePacked(const std::byte *problem, std::size_t size, std::vector<std::byte> &result);

// What this process says of itself to others: its version, its numbers, and the bits of its solutions of known problems. Throws
// std::bad_alloc.
dxRemoteHello dxDescribeSolver();
