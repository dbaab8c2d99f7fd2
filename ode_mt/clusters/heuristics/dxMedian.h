// The middle one of some numbers, which odd ones (a frame during which the system took the thread off its
// core) do not move.
#pragma once

#include <vector>

// The lower of the two middle numbers if their count is even; 0 if there are none. No number may be NaN.
// Reorders them.
double dxMedian(std::vector<double> &numbers);
