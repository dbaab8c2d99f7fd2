#include "RandomBoxes.h"

#include <cmath>
#include <utility>

dxBounds RandomBoxes::properBox() {
    const dReal reach = std::pow(dReal(10), uniform(0, 2)), edge = std::pow(dReal(10), uniform(-4, 2));
    dxBounds box;
    for (int axis = 0; axis < 3; ++axis) {
        const dReal low = uniform(-reach, reach);
        box.v[2 * axis] = low;
        box.v[2 * axis + 1] = low + edge * uniform(0, 1);
    }
    return box;
}

dxBounds RandomBoxes::box() {
    dxBounds box = properBox();
    if (oneIn(30)) box.v[below(6)] = oneIn(2) ? kInfinite : -kInfinite;
    if (oneIn(30)) box.v[below(6)] = kNaN;
    if (oneIn(30)) std::swap(box.v[2], box.v[3]);
    if (oneIn(50)) box.v[below(6)] *= dReal(1e15);  // beyond the numbers of small cells
    return box;
}
