#include "clusters/dxCrossoverPass.h"

#include <algorithm>

namespace {

using Kind = dxClusterScene::Kind;
using Slot = dxMembers::Slot;

void uniteWithNeighbour(const dxClusterScene &scene, Kind kind, Slot slot, int cell, int x, int y, int z,
                        dxDisjointSets &sets) {
    const int cells = scene.grid().cells();
    const auto unite = [&](int neighbour) {
        const std::vector<Slot> &others = scene.in(neighbour, kind);
        if (!others.empty()) sets.unite(slot, others.front());
    };
    if (x + 1 < cells) unite(cell + cells * cells);
    if (y + 1 < cells) unite(cell + cells);
    if (z + 1 < cells) unite(cell + 1);
}

// Visits every pair (dynamic cluster, cell that it occupies); a cell may come more than once.
template <class Visit>
void forOccupiedCells(const dxClusterScene &scene, const dxClusters &clusters, Visit &&visit) {
    for (const int cell : scene.occupied()) visit(clusters.of(scene.in(cell, Kind::dynamicGeom).front()), cell);
}

void sortUnique(std::vector<Slot> &slots) {
    std::sort(slots.begin(), slots.end());
    slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
}

bool inRange(const dxCellRange &range, int cell, int cells) {
    const int x = cell / (cells * cells), y = cell / cells % cells, z = cell % cells;
    return range.low[0] <= x && x <= range.high[0] && range.low[1] <= y && y <= range.high[1] &&
           range.low[2] <= z && z <= range.high[2];
}

}  // namespace

void dxUniteByCells(const dxClusterScene &scene, Kind kind, dxTogetherness togetherness, dxDisjointSets &sets) {
    const dxClusterGrid &grid = scene.grid();
    for (const Slot slot : scene.all(kind)) {
        const dxCellRange &range = scene[slot].cells;
        for (int x = range.low[0]; x <= range.high[0]; ++x)
            for (int y = range.low[1]; y <= range.high[1]; ++y)
                for (int z = range.low[2]; z <= range.high[2]; ++z) {
                    const int cell = grid.index(x, y, z);
                    sets.unite(slot, scene.in(cell, kind).front());
                    if (togetherness == dxTogetherness::touching)
                        uniteWithNeighbour(scene, kind, slot, cell, x, y, z, sets);
                }
    }
}

void dxUniteByLinks(const std::vector<dxCrossoverPass::Link> &links, dxDisjointSets &sets) {
    for (const dxCrossoverPass::Link &link : links) sets.unite(link.first, link.second);
}

void dxUniteAsBefore(const dxClusterScene &scene, Kind kind, const dxClusters &before,
                     dxCrossoverMemory &memory) {
    std::vector<std::int64_t> &firstOf = memory.firstOfCluster;
    firstOf.assign(before.count(), -1);
    for (const Slot slot : scene.all(kind)) {
        const int cluster = before.of(slot);
        if (cluster == dxClusters::kNone) continue;
        if (firstOf[cluster] >= 0) memory.sets.unite(slot, static_cast<Slot>(firstOf[cluster]));
        firstOf[cluster] = slot;
    }
}

void dxMakeClusters(const dxClusterScene &scene, Kind kind, dxCrossoverMemory &memory, dxClusters &clusters) {
    memory.clusterOfRoot.assign(scene.end(), dxClusters::kNone);
    const auto join = [&](Slot slot) {
        int &cluster = memory.clusterOfRoot[memory.sets.find(slot)];
        if (cluster == dxClusters::kNone) cluster = clusters.addCluster(kind == Kind::dynamicGeom);
        clusters.addMember(cluster, slot);
    };
    for (const Slot slot : scene.all(kind)) join(slot);
}

void dxClusterDynamics(const dxClusterScene &scene, const std::vector<dxCrossoverPass::Link> &links,
                       const dxClusters *sticky, dxCrossoverMemory &memory, dxClusters &clusters) {
    dxDisjointSets &sets = memory.sets;
    sets.reset(scene.end());
    const bool first = sticky == nullptr || sticky->count() == 0;
    dxUniteByCells(scene, Kind::dynamicGeom, first ? dxTogetherness::touching : dxTogetherness::sharing, sets);
    dxUniteByLinks(links, sets);
    if (sticky != nullptr) dxUniteAsBefore(scene, Kind::dynamicGeom, *sticky, memory);
    dxMakeClusters(scene, Kind::dynamicGeom, memory, clusters);
}

void dxPseudoMerge(const dxClusterScene &scene, dxCrossoverMemory &memory, dxClusters &clusters) {
    forOccupiedCells(scene, clusters, [&](int cluster, int cell) {
        for (const Slot slot : scene.in(cell, Kind::staticGeom))
            clusters[cluster].staticClusters.push_back(clusters.of(slot));
    });
    dxDisjointSets &tasks = memory.sets;
    tasks.reset(clusters.count());
    for (int cluster = 0; cluster < clusters.dynamicCount(); ++cluster) {
        std::vector<int> &statics = clusters[cluster].staticClusters;
        std::sort(statics.begin(), statics.end());
        statics.erase(std::unique(statics.begin(), statics.end()), statics.end());
        for (const int other : statics) tasks.unite(cluster, other);
    }
    for (int cluster = 0; cluster < clusters.dynamicCount(); ++cluster)
        clusters[cluster].task = static_cast<int>(tasks.find(cluster));
}

void dxDuplicateStatics(const dxClusterScene &scene, dxClusters &clusters) {
    const int cells = scene.grid().cells();
    forOccupiedCells(scene, clusters, [&](int cluster, int cell) {
        std::vector<Slot> &duplicated = clusters[cluster].duplicated;
        const std::vector<Slot> &statics = scene.in(cell, Kind::staticGeom);
        duplicated.insert(duplicated.end(), statics.begin(), statics.end());
        for (const Slot slot : scene.big())
            if (scene[slot].kind == Kind::staticGeom && inRange(scene[slot].cells, cell, cells))
                duplicated.push_back(slot);
    });
    for (int cluster = 0; cluster < clusters.dynamicCount(); ++cluster) sortUnique(clusters[cluster].duplicated);
}
