// "duplication" (thesis chapter 7): a static geom near several dynamic clusters is listed in each of them, planes
// and other big geoms too, so it no longer joins them; what flies above the floor is not tested with it.
#include "clusters/passes/passes.h"

namespace {

class Duplication final : public dxCrossoverPass {
public:
    const char *name() const override { return "duplication"; }
    bool listsBigStatics() const override { return true; }
    void cross(const dxClusterScene &scene, const std::vector<Link> &links, const dxClusters &before,
               dxClusters &clusters) override {
        dxClusterDynamics(scene, links, &before, m_memory, clusters);
        dxDuplicateStatics(scene, clusters);
    }
};

}  // namespace

std::unique_ptr<dxCrossoverPass> dxMakeDuplicationPass() { return std::make_unique<Duplication>(); }
