// Memory that is reserved beforehand: every list of the members of a space has capacity for each member once it is
// added, so that cleaning and changes of geoms never allocate, and cannot fail half way.
#pragma once

#include <algorithm>

// Reserves capacity for `count` items, with geometric growth.
template <class Vector>
void dxReserveCapacity(Vector &vector, std::size_t count) {
    if (vector.capacity() < count) vector.reserve(std::max(count, 2 * vector.capacity()));
}
