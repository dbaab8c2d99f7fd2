// Memory that is taken ahead: what keeps a list of the members of a space has room for each of them once it
// is in, so that cleaning and changes of geoms never ask for memory, and cannot be left half done where there
// is none.
#pragma once

#include <algorithm>

// Room for so many items. Grows as vectors do.
template <class Vector>
void dxMakeRoom(Vector &vector, std::size_t count) {
    if (vector.capacity() < count) vector.reserve(std::max(count, 2 * vector.capacity()));
}
