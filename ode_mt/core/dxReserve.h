// Memory that is reserved in advance: every list of the members of a space has capacity for each member from its addition on,
// so that cleaning and changes of geoms never allocate, and cannot fail half way. Lists whose length
// changes from step to step grow as if by push_back, so that a scene at rest soon allocates no more.
#pragma once

#include <algorithm>
#include <cstddef>

// Reserves capacity for `count` items, with geometric growth.
template <class Vector>
void dxReserveCapacity(Vector &vector, std::size_t count) {
    if (vector.capacity() < count) vector.reserve(std::max(count, 2 * vector.capacity()));
}
