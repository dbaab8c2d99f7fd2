// "original" (thesis chapter 2): only what is dynamic is clustered; clusters that share a cell merge and stay merged;
// static geoms and planes are tested apart, with every cluster.
#include "clusters/passes/passes.h"

namespace {

class Original final : public dxCrossoverPass {
public:
    const char *name() const override { return "original"; }
    bool setsStaticsApart() const override { return true; }
    void cross(const dxClusterScene &scene, const std::vector<Link> &links, const dxClusters &before,
               dxClusters &clusters) override {
        dxClusterDynamics(scene, links, &before, m_memory, clusters);
    }
};

}  // namespace

std::unique_ptr<dxCrossoverPass> dxMakeOriginalPass() { return std::make_unique<Original>(); }
