// What may be left out in a lower triangle.
#pragma once

#include <ode/common.h>

// The triangle has n rows, the diagonal included, which start rowSkip elements apart.

// No element of rows begin..end-1 is infinite or NaN. May raise FE_INVALID if one is.
bool dxAreRowsFinite(const dReal *triangle, unsigned begin, unsigned end, unsigned rowSkip);

// begins[row] = the row's first column that is not +0; its diagonal if there is none before.
void dxFindSkyline(const dReal *triangle, unsigned n, unsigned rowSkip, unsigned *begins);
