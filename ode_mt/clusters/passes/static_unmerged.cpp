// "static-unmerged" (thesis chapter 6): as "static", but static clusters never merge, so each holds one geom, and a
// dynamic cluster is tested only with those with which it shares a cell.
#include "clusters/passes/passes.h"

namespace {

class StaticUnmerged final : public dxCrossoverPass {
public:
    const char *name() const override { return "static-unmerged"; }
    void cross(const dxClusterScene &scene, const std::vector<Link> &links, const dxClusters &before,
               dxClusters &clusters) override {
        dxClusterDynamics(scene, links, &before, m_memory, clusters);
        m_memory.sets.reset(scene.end());
        dxMakeClusters(scene, dxClusterScene::Kind::staticGeom, m_memory, clusters);
        dxPseudoMerge(scene, m_memory, clusters);
    }
};

}  // namespace

std::unique_ptr<dxCrossoverPass> dxMakeStaticUnmergedPass() { return std::make_unique<StaticUnmerged>(); }
