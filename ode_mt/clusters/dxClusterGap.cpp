#include "clusters/dxClusterGap.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using Kind = dxClusterScene::Kind;
using Slot = dxMembers::Slot;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// Returns a difference that is not above the exact one, if that is positive.
double difference(dReal high, dReal low) {
    const double rounded = static_cast<double>(high) - static_cast<double>(low);
    return std::nextafter(rounded, 0.0);
}

// Returns the gap, at most 0 if the boxes may overlap. An axis with a NaN is ignored.
double gapBetween(const dxBounds &a, const dxBounds &b) {
    double gap = 0;
    for (int axis = 0; axis < 3; ++axis)
        gap = std::fmax(gap, std::fmax(difference(a.low(axis), b.high(axis)), difference(b.low(axis), a.high(axis))));
    return gap;
}

dxBounds boxAround(const std::vector<Slot> &members, const dxClusterScene &scene) {
    dxBounds box = scene[members.front()].bounds;
    for (const Slot slot : members) box.include(scene[slot].bounds);
    return box;
}

// Returns how far a bound may move, either way, without leaving its cell. Border cells are unlimited outwards.
double distanceToCellFace(dReal bound, int axis, const dxClusterGrid &grid) {
    const dReal corner = grid.centre()[axis] - grid.edge() * dReal(grid.cells()) / 2;
    const dReal cell = (bound - corner) / grid.edge();
    const dReal below = cell < 1 ? dReal(kInfinite) : cell - dFloor(cell);
    const dReal above = cell >= dReal(grid.cells() - 1) ? dReal(kInfinite) : dFloor(cell) + 1 - cell;
    return static_cast<double>(std::min(below, above) * grid.edge());
}

double distanceToCellFaces(const dxBounds &box, const dxClusterGrid &grid) {
    double room = kInfinite;
    for (int bound = 0; bound < 6; ++bound) room = std::min(room, distanceToCellFace(box.v[bound], bound / 2, grid));
    return room;
}

}  // namespace

double dxClusterGap::toOthers(const dxClusterScene &scene, const dxClusters &clusters, const dxCrossoverPass &pass) {
    gather(scene, clusters, pass);
    const double reach = static_cast<double>(scene.grid().edge());
    double gap = kInfinite;
    for (int cluster = 0; cluster < clusters.dynamicCount() && gap > 0; ++cluster)
        gap = std::min(gap, gapOf(cluster, clusters, reach));
    return gap;
}

void dxClusterGap::gather(const dxClusterScene &scene, const dxClusters &clusters, const dxCrossoverPass &pass) {
    m_boxes.clear();
    m_statics.clear();
    for (int cluster = 0; cluster < clusters.dynamicCount(); ++cluster)
        m_boxes.push_back(boxAround(clusters[cluster].members, scene));
    const auto pushStatic = [&](Slot slot) {
        m_statics.push_back(slot);
        m_boxes.push_back(scene[slot].bounds);
    };
    if (!pass.setsStaticsApart())
        for (const Slot slot : scene.all(Kind::staticGeom)) pushStatic(slot);
    if (pass.listsBigStatics())
        for (const Slot slot : scene.big())
            if (scene[slot].kind == Kind::staticGeom) pushStatic(slot);
    m_table.clear();
    for (const dxBounds &box : m_boxes) m_table.push(box);
    m_rows.resize(m_boxes.size());
}

// The boxes that are not found within `reach` are further away than half of it. Rounding of the grown box cannot hide a nearer one:
// where it could, the numbers are so large that adjacent ones are further apart than that.
double dxClusterGap::gapOf(int cluster, const dxClusters &clusters, double reach) {
    const dxBounds around = m_boxes[cluster].grown(dReal(reach));
    const std::size_t found = dxOverlappingRows(m_table, around, 0, m_table.size(), m_rows.data());
    std::size_t tested = 0;
    double gap = reach / 2;
    for (std::size_t i = 0; i < found && gap > 0; ++i) {
        if (isTestedWith(cluster, m_rows[i], clusters)) ++tested;
        else gap = std::min(gap, gapBetween(m_boxes[cluster], m_boxes[m_rows[i]]));
    }
    return tested == m_boxes.size() ? kInfinite : gap;
}

bool dxClusterGap::isTestedWith(int cluster, std::size_t row, const dxClusters &clusters) const {
    const auto dynamics = static_cast<std::size_t>(clusters.dynamicCount());
    if (row < dynamics) return row == static_cast<std::size_t>(cluster);
    const Slot slot = m_statics[row - dynamics];
    const std::vector<Slot> &duplicated = clusters[cluster].duplicated;
    if (std::binary_search(duplicated.begin(), duplicated.end(), slot)) return true;
    const std::vector<int> &statics = clusters[cluster].staticClusters;
    return clusters.of(slot) != dxClusters::kNone &&
           std::binary_search(statics.begin(), statics.end(), clusters.of(slot));
}

double dxGapBeforeCut(const dxClusterScene &scene, const dxClusters &clusters,
                      const std::vector<dxCrossoverPass::Link> &links) {
    dxDisjointSets entities;
    entities.reset(scene.end());
    dxUniteByLinks(links, entities);
    double room = kInfinite;
    for (int cluster = 0; cluster < clusters.dynamicCount(); ++cluster) {
        const std::vector<Slot> &members = clusters[cluster].members;
        const auto first = entities.find(members.front());
        if (std::all_of(members.begin(), members.end(), [&](Slot slot) { return entities.find(slot) == first; }))
            continue;
        for (const Slot slot : members) room = std::min(room, distanceToCellFaces(scene[slot].bounds, scene.grid()));
    }
    return 2 * room;
}
