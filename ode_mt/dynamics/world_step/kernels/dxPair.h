// Two numbers side by side, for loops that are too short to be worth a dispatch: every processor that the library is
// compiled for has instructions for them.
#pragma once

#include <ode/common.h>

#include <cstring>

typedef dReal dxPair __attribute__((vector_size(2 * sizeof(dReal))));

inline dxPair dxLoadPair(const dReal *from) {
    dxPair pair;
    std::memcpy(&pair, from, sizeof pair);
    return pair;
}

inline void dxStorePair(dxPair pair, dReal *to) { std::memcpy(to, &pair, sizeof pair); }
