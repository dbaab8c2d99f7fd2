// QuickStep's sweep over the rows of an island (successive over-relaxation), which takes most of its time. docs/exact.md tells
// why the bits are those of upstream's loop.
#pragma once

#include <cstddef>
#include <cstdint>

#include "dynamics/step/islands/dxIslandProblem.h"

// Relaxes every row once, in this order. Each row's columns are scaled and its impulse is set (dxSorSolver). `isLarge`: of the problem whose rows
// these are, or a part of them.
void dxSorSweep(const dxIslandProblem &problem, const int *order, bool isLarge);

// --- a part of a sweep: consecutive rows up to a dependency on another thread (dxParallelSor) ---------------------

// An entry of a list of rows: the number of a row, and marks.
namespace dxSorRun {
constexpr std::uint32_t kWaits = UINT32_C(1) << 30;      // waits for another thread to finish a certain row
constexpr std::uint32_t kAnnounces = UINT32_C(1) << 31;  // other threads may be waiting for it
constexpr std::uint32_t kRow = kWaits - 1;
}  // namespace dxSorRun

// Takes entries from `begin` on: up to one that announces, that included, or the next one that waits, or
// `end`. The first one does not wait any more. Returns the entry to go on with.
std::size_t dxRelaxRun(const dxIslandProblem &problem, const std::uint32_t *entries, std::size_t begin, std::size_t end);
