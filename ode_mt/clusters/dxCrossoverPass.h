// A crossover pass: the rule by which inhabitants of the grid become clusters (thesis chapters 2, 5 to 8).
// One traversal of the occupied cells, of the inhabitants and of their links: O(n).
//
// Whatever the rule, two dynamic inhabitants that share a cell are in one cluster, and whatever static
// inhabitant shares a cell with a dynamic one is tested with its cluster; so no overlapping pair is missed.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "clusters/dxClusterScene.h"
#include "clusters/dxClusters.h"
#include "core/dxDisjointSets.h"

// What the pieces below work with, kept so that a pass takes no memory once it has run.
struct dxCrossoverMemory {
    dxDisjointSets sets;
    std::vector<std::int64_t> firstOfCluster;  // -1: none
    std::vector<int> clusterOfRoot;
};

class dxCrossoverPass {
public:
    using Slot = dxMembers::Slot;
    // Two inhabitants that belong together wherever they are: geoms of one body, or of jointed bodies.
    using Link = std::pair<Slot, Slot>;

    virtual ~dxCrossoverPass() = default;

    virtual const char *name() const = 0;
    // Static inhabitants are tested with every cluster: the rule does not place them.
    virtual bool setsStaticsApart() const { return false; }
    // Big static inhabitants are listed where they are near; else they are tested with every cluster.
    virtual bool listsBigStatics() const { return false; }
    // A cluster whose cells have come apart is split.
    virtual bool splits() const { return false; }
    // `before`: the clusters of the last frame, for rules under which what has merged stays merged.
    virtual void cross(const dxClusterScene &scene, const std::vector<Link> &links, const dxClusters &before,
                       dxClusters &clusters) = 0;

protected:
    dxCrossoverMemory m_memory;
};

// --- pieces that the rules are made of --------------------------------------------------------------

enum class dxTogetherness {
    sharing,   // inhabitants of one cell belong together
    touching,  // and so do those of cells with a common face: what flood fill finds when clusters are made
};

// Unites what cells hold together, among inhabitants of one kind.
void dxUniteByCells(const dxClusterScene &scene, dxClusterScene::Kind kind, dxTogetherness togetherness,
                    dxDisjointSets &sets);
void dxUniteByLinks(const std::vector<dxCrossoverPass::Link> &links, dxDisjointSets &sets);
// Unites what was one cluster before.
void dxUniteAsBefore(const dxClusterScene &scene, dxClusterScene::Kind kind, const dxClusters &before,
                     dxCrossoverMemory &memory);
// One cluster for each set.
void dxMakeClusters(const dxClusterScene &scene, dxClusterScene::Kind kind, dxCrossoverMemory &memory,
                    dxClusters &clusters);

// Dynamic clusters as all rules make them; sticky: what has merged stays merged.
void dxClusterDynamics(const dxClusterScene &scene, const std::vector<dxCrossoverPass::Link> &links,
                       const dxClusters *sticky, dxCrossoverMemory &memory, dxClusters &clusters);

// Each dynamic cluster gets the static clusters with which it shares a cell; dynamic clusters around the same
// static one become one task.
void dxPseudoMerge(const dxClusterScene &scene, dxCrossoverMemory &memory, dxClusters &clusters);
// Each dynamic cluster gets the static inhabitants with which it shares a cell, big ones included.
void dxDuplicateStatics(const dxClusterScene &scene, dxClusters &clusters);

// Returns the pass of a name, NULL for others: "original", "static", "static-unmerged", "duplication" or "decluster".
std::unique_ptr<dxCrossoverPass> dxMakeCrossoverPass(const std::string &name);
