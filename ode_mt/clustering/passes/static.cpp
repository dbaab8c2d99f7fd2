// "static" (thesis chapter 5): static geoms are clustered too, and such clusters merge with one another; a
// dynamic and a static cluster that meet are tested together, without becoming one.
#include "clustering/passes/passes.h"

namespace {

class Static final : public dxCrossoverPass {
public:
    const char *name() const override { return "static"; }
    void cross(const dxClusterScene &scene, const std::vector<Link> &links, const dxClusters &before,
               dxClusters &clusters) override {
        dxClusterDynamics(scene, links, &before, clusters);
        dxDisjointSets sets;
        sets.reset(scene.end());
        dxUniteByCells(scene, dxClusterScene::Kind::staticGeom, dxTogetherness::sharing, sets);
        dxUniteAsBefore(scene, dxClusterScene::Kind::staticGeom, before, sets);
        dxMakeClusters(scene, dxClusterScene::Kind::staticGeom, sets, clusters);
        dxPseudoMerge(scene, clusters);
    }
};

}  // namespace

std::unique_ptr<dxCrossoverPass> dxMakeStaticPass() { return std::make_unique<Static>(); }
