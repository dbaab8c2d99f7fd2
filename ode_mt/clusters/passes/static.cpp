// "static" (thesis chapter 5): static geoms are clustered too, and such clusters merge with one another; a dynamic and
// a static cluster that share a cell are tested together, without becoming one.
#include "clusters/passes/passes.h"

namespace {

class Static final : public dxCrossoverPass {
public:
    const char *name() const override { return "static"; }
    void cross(const dxClusterScene &scene, const std::vector<Link> &links, const dxClusters &before,
               dxClusters &clusters) override {
        dxClusterDynamics(scene, links, &before, m_memory, clusters);
        m_memory.sets.reset(scene.end());
        dxUniteByCells(scene, dxClusterScene::Kind::staticGeom, dxTogetherness::sharing, m_memory.sets);
        dxUniteAsBefore(scene, dxClusterScene::Kind::staticGeom, before, m_memory);
        dxMakeClusters(scene, dxClusterScene::Kind::staticGeom, m_memory, clusters);
        dxPseudoMerge(scene, m_memory, clusters);
    }
};

}  // namespace

std::unique_ptr<dxCrossoverPass> dxMakeStaticPass() { return std::make_unique<Static>(); }
