#include "clusters/dxCrossoverPass.h"

#include <algorithm>

namespace {

using Kind = dxClusterScene::Kind;
using Slot = dxMembers::Slot;
using Link = dxCrossoverPass::Link;

// ---- Steps of which the rules consist --------------------------------------------------------------------------------------------------

enum class Togetherness {
    sharing,   // inhabitants of one cell belong together
    touching,  // and so do those of cells with a common face: the result of flood fill when clusters are made
};

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

template <class Value>
void sortUnique(std::vector<Value> &values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

bool inRange(const dxCellRange &range, int cell, int cells) {
    const int x = cell / (cells * cells), y = cell / cells % cells, z = cell % cells;
    return range.low[0] <= x && x <= range.high[0] && range.low[1] <= y && y <= range.high[1] &&
           range.low[2] <= z && z <= range.high[2];
}

// Unites inhabitants of one kind that belong together by their cells.
void uniteByCells(const dxClusterScene &scene, Kind kind, Togetherness togetherness, dxDisjointSets &sets) {
    const dxClusterGrid &grid = scene.grid();
    for (const Slot slot : scene.all(kind)) {
        const dxCellRange &range = scene[slot].cells;
        for (int x = range.low[0]; x <= range.high[0]; ++x)
            for (int y = range.low[1]; y <= range.high[1]; ++y)
                for (int z = range.low[2]; z <= range.high[2]; ++z) {
                    const int cell = grid.index(x, y, z);
                    sets.unite(slot, scene.in(cell, kind).front());
                    if (togetherness == Togetherness::touching) uniteWithNeighbour(scene, kind, slot, cell, x, y, z, sets);
                }
    }
}

// Unites inhabitants that were in one cluster before.
void uniteAsBefore(const dxClusterScene &scene, Kind kind, const dxClusters &before, dxCrossoverMemory &memory) {
    std::vector<std::int64_t> &firstOf = memory.firstOfCluster;
    firstOf.assign(before.count(), -1);
    for (const Slot slot : scene.all(kind)) {
        const int cluster = before.of(slot);
        if (cluster == dxClusters::kNone) continue;
        if (firstOf[cluster] >= 0) memory.sets.unite(slot, static_cast<Slot>(firstOf[cluster]));
        firstOf[cluster] = slot;
    }
}

// Makes one cluster of each set.
void makeClusters(const dxClusterScene &scene, Kind kind, dxCrossoverMemory &memory, dxClusters &clusters) {
    memory.clusterOfRoot.assign(scene.end(), dxClusters::kNone);
    const auto join = [&](Slot slot) {
        int &cluster = memory.clusterOfRoot[memory.sets.find(slot)];
        if (cluster == dxClusters::kNone) cluster = clusters.addCluster(kind == Kind::dynamicGeom);
        clusters.addMember(cluster, slot);
    };
    for (const Slot slot : scene.all(kind)) join(slot);
}

// Makes dynamic clusters as all rules do. `sticky`: the clusters before, which stay merged, or null.
void clusterDynamics(const dxClusterScene &scene, const std::vector<Link> &links, const dxClusters *sticky, dxCrossoverMemory &memory,
                     dxClusters &clusters) {
    dxDisjointSets &sets = memory.sets;
    sets.reset(scene.end());
    const bool first = sticky == nullptr || sticky->count() == 0;
    uniteByCells(scene, Kind::dynamicGeom, first ? Togetherness::touching : Togetherness::sharing, sets);
    dxUniteByLinks(links, sets);
    if (sticky != nullptr) uniteAsBefore(scene, Kind::dynamicGeom, *sticky, memory);
    makeClusters(scene, Kind::dynamicGeom, memory, clusters);
}

// Gives each dynamic cluster the static clusters with which it shares a cell; dynamic clusters around the same static one become one task.
void pseudoMerge(const dxClusterScene &scene, dxCrossoverMemory &memory, dxClusters &clusters) {
    forOccupiedCells(scene, clusters, [&](int cluster, int cell) {
        for (const Slot slot : scene.in(cell, Kind::staticGeom))
            clusters[cluster].staticClusters.push_back(clusters.of(slot));
    });
    dxDisjointSets &tasks = memory.sets;
    tasks.reset(clusters.count());
    for (int cluster = 0; cluster < clusters.dynamicCount(); ++cluster) {
        std::vector<int> &statics = clusters[cluster].staticClusters;
        sortUnique(statics);
        for (const int other : statics) tasks.unite(cluster, other);
    }
    for (int cluster = 0; cluster < clusters.dynamicCount(); ++cluster)
        clusters[cluster].task = static_cast<int>(tasks.find(cluster));
}

// Gives each dynamic cluster the static inhabitants with which it shares a cell, big ones included.
void duplicateStatics(const dxClusterScene &scene, dxClusters &clusters) {
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

// ---- Passes ----------------------------------------------------------------------------------------------------------------------------

// "original" (thesis chapter 2): only what is dynamic is clustered; clusters that share a cell merge and stay merged;
// static geoms and planes are tested apart, with every cluster.
class Original final : public dxCrossoverPass {
public:
    const char *name() const override { return "original"; }
    bool setsStaticsApart() const override { return true; }
    void cross(const dxClusterScene &scene, const std::vector<Link> &links, const dxClusters &before,
               dxClusters &clusters) override {
        clusterDynamics(scene, links, &before, m_memory, clusters);
    }
};

// "static" (thesis chapter 5): static geoms are clustered too, and such clusters merge with one another; a dynamic and
// a static cluster that share a cell are tested together, without becoming one.
class Static final : public dxCrossoverPass {
public:
    const char *name() const override { return "static"; }
    void cross(const dxClusterScene &scene, const std::vector<Link> &links, const dxClusters &before,
               dxClusters &clusters) override {
        clusterDynamics(scene, links, &before, m_memory, clusters);
        m_memory.sets.reset(scene.end());
        uniteByCells(scene, Kind::staticGeom, Togetherness::sharing, m_memory.sets);
        uniteAsBefore(scene, Kind::staticGeom, before, m_memory);
        makeClusters(scene, Kind::staticGeom, m_memory, clusters);
        pseudoMerge(scene, m_memory, clusters);
    }
};

// "static-unmerged" (thesis chapter 6): as "static", but static clusters never merge, so each holds one geom, and a
// dynamic cluster is tested only with those with which it shares a cell.
class StaticUnmerged final : public dxCrossoverPass {
public:
    const char *name() const override { return "static-unmerged"; }
    void cross(const dxClusterScene &scene, const std::vector<Link> &links, const dxClusters &before,
               dxClusters &clusters) override {
        clusterDynamics(scene, links, &before, m_memory, clusters);
        m_memory.sets.reset(scene.end());
        makeClusters(scene, Kind::staticGeom, m_memory, clusters);
        pseudoMerge(scene, m_memory, clusters);
    }
};

// "duplication" (thesis chapter 7): a static geom near several dynamic clusters is listed in each of them, planes
// and other big geoms too, so it no longer joins them; a geom that flies above the floor is not tested with it.
class Duplication final : public dxCrossoverPass {
public:
    const char *name() const override { return "duplication"; }
    bool listsBigStatics() const override { return true; }
    void cross(const dxClusterScene &scene, const std::vector<Link> &links, const dxClusters &before,
               dxClusters &clusters) override {
        clusterDynamics(scene, links, &before, m_memory, clusters);
        duplicateStatics(scene, clusters);
    }
};

// "decluster" (thesis chapter 8): as "duplication", and a cluster whose cells have fallen apart is split, found in
// the same traversal: clusters are made anew from the cells, as flood fill would, in every frame.
class Decluster final : public dxCrossoverPass {
public:
    const char *name() const override { return "decluster"; }
    bool listsBigStatics() const override { return true; }
    bool splits() const override { return true; }
    void cross(const dxClusterScene &scene, const std::vector<Link> &links, const dxClusters &,
               dxClusters &clusters) override {
        clusterDynamics(scene, links, nullptr, m_memory, clusters);
        duplicateStatics(scene, clusters);
    }
};

}  // namespace

void dxUniteByLinks(const std::vector<Link> &links, dxDisjointSets &sets) {
    for (const Link &link : links) sets.unite(link.first, link.second);
}

std::unique_ptr<dxCrossoverPass> dxMakeCrossoverPass(const std::string &name) {
    std::unique_ptr<dxCrossoverPass> passes[] = {std::make_unique<Original>(), std::make_unique<Static>(), std::make_unique<StaticUnmerged>(),
                                                 std::make_unique<Duplication>(), std::make_unique<Decluster>()};
    for (auto &pass : passes)
        if (pass->name() == name) return std::move(pass);
    return nullptr;
}
