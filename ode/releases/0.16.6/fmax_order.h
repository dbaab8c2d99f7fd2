/* libccd's maximum, with its arguments in the order that Debian 13's binary has: g++ 14 took the order to be free, and exchanged them.
 * It decides the sign of a zero, for the depth of a contact of a convex geom with a mesh. */
#pragma once

#include <ccd/vec3.h>

#undef CCD_FMAX
#define CCD_FMAX(x, y) fmax((y), (x))
