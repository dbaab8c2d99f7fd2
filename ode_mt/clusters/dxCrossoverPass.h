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

// Scratch of a pass, kept so that a pass takes no memory once it has run.
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

// Unites inhabitants that are linked.
void dxUniteByLinks(const std::vector<dxCrossoverPass::Link> &links, dxDisjointSets &sets);

// Returns the pass of a name, NULL for others: "original", "static", "static-unmerged", "duplication" or "decluster".
std::unique_ptr<dxCrossoverPass> dxMakeCrossoverPass(const std::string &name);
