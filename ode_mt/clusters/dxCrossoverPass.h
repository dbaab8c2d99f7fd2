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

// Scratch of the functions below, kept so that a pass takes no memory once it has run.
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
    // Returns whether static inhabitants are in no cluster, and are tested with every one.
    virtual bool setsStaticsApart() const { return false; }
    // Returns whether big static inhabitants are listed in the clusters near them; else they are tested with every cluster.
    virtual bool listsBigStatics() const { return false; }
    // Returns whether a cluster whose cells have come apart is split.
    virtual bool splits() const { return false; }
    // `before`: the clusters of the last frame, for rules under which what has merged stays merged.
    virtual void cross(const dxClusterScene &scene, const std::vector<Link> &links, const dxClusters &before,
                       dxClusters &clusters) = 0;

protected:
    dxCrossoverMemory m_memory;
};

// --- Steps of which the rules consist ---------------------------------------------------------------

enum class dxTogetherness {
    sharing,   // inhabitants of one cell belong together
    touching,  // and so do those of cells with a common face: the result of flood fill when clusters are made
};

// Unites inhabitants of one kind that belong together by their cells.
void dxUniteByCells(const dxClusterScene &scene, dxClusterScene::Kind kind, dxTogetherness togetherness,
                    dxDisjointSets &sets);
void dxUniteByLinks(const std::vector<dxCrossoverPass::Link> &links, dxDisjointSets &sets);
// Unites inhabitants that were in one cluster before.
void dxUniteAsBefore(const dxClusterScene &scene, dxClusterScene::Kind kind, const dxClusters &before,
                     dxCrossoverMemory &memory);
// Makes one cluster of each set.
void dxMakeClusters(const dxClusterScene &scene, dxClusterScene::Kind kind, dxCrossoverMemory &memory,
                    dxClusters &clusters);

// Makes dynamic clusters as all rules do. `sticky`: the clusters before, which stay merged, or null.
void dxClusterDynamics(const dxClusterScene &scene, const std::vector<dxCrossoverPass::Link> &links,
                       const dxClusters *sticky, dxCrossoverMemory &memory, dxClusters &clusters);

// Gives each dynamic cluster the static clusters with which it shares a cell; dynamic clusters around the same
// static one become one task.
void dxPseudoMerge(const dxClusterScene &scene, dxCrossoverMemory &memory, dxClusters &clusters);
// Gives each dynamic cluster the static inhabitants with which it shares a cell, big ones included.
void dxDuplicateStatics(const dxClusterScene &scene, dxClusters &clusters);

// Returns the pass of a name, NULL for others: "original", "static", "static-unmerged", "duplication" or "decluster".
std::unique_ptr<dxCrossoverPass> dxMakeCrossoverPass(const std::string &name);
