// The instruction set that ODE_MT's vector kernels use on this processor: the best of those that they are compiled for.
#pragma once

namespace info {

struct VectorWidth {
    const char *instructionSet;  // as Google Highway names it
    int bits;
};

VectorWidth vectorWidth();

}  // namespace info
