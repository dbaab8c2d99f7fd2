#include "clusters/dxGridFit.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using Kind = dxClusterScene::Kind;

constexpr double kStrays = 0.02;          // share of the inhabitants that may lie beyond either end of an axis
constexpr dReal kRelativeSize = 1.5;              // the grid is this many times as long as what it is for
constexpr double kOutside = 6 * kStrays;  // share outside above which a grid is outgrown: more than a fit leaves

template <class Visit>
void forDynamics(const dxClusterScene &scene, Visit &&visit) {
    for (dxClusterScene::Slot slot = 0; slot < scene.end(); ++slot)
        if (scene[slot].kind == Kind::dynamicGeom && scene[slot].bounds.isProper()) visit(scene[slot].bounds);
}

struct Extent {
    dReal low = 0, high = 0;
};

Extent extentOf(std::vector<dReal> &lows, std::vector<dReal> &highs) {
    const auto strays = static_cast<std::ptrdiff_t>(kStrays * static_cast<double>(lows.size()));
    std::nth_element(lows.begin(), lows.begin() + strays, lows.end());
    std::nth_element(highs.begin(), highs.end() - 1 - strays, highs.end());
    return {lows[strays], *(highs.end() - 1 - strays)};
}

}  // namespace

dxClusterGrid dxFitGrid(const dxClusterScene &scene, int cells) {
    std::vector<dReal> lows[3], highs[3];
    forDynamics(scene, [&](const dxBounds &box) {
        for (int axis = 0; axis < 3; ++axis) {
            lows[axis].push_back(box.low(axis));
            highs[axis].push_back(box.high(axis));
        }
    });
    dReal centre[3] = {0, 0, 0}, longest = 0;
    for (int axis = 0; axis < 3 && !lows[axis].empty(); ++axis) {
        const Extent extent = extentOf(lows[axis], highs[axis]);
        centre[axis] = extent.low / 2 + extent.high / 2;
        longest = std::max(longest, extent.high - extent.low);
    }
    const dReal edge = longest * kRelativeSize / dReal(cells);
    const bool usable = std::isfinite(edge) && edge > 0;
    return dxClusterGrid(cells, usable ? edge : dReal(1), centre);
}

double dxShareOutside(const dxClusterScene &scene) {
    std::size_t all = 0, outside = 0;
    forDynamics(scene, [&](const dxBounds &box) {
        ++all;
        outside += scene.grid().isLeftBy(box);
    });
    return all > 0 ? static_cast<double>(outside) / static_cast<double>(all) : 0;
}

bool dxGridIsOutgrown(const dxClusterScene &scene) { return dxShareOutside(scene) > kOutside; }
