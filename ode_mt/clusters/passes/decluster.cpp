// "decluster" (thesis chapter 8): as "duplication", and a cluster whose cells have fallen apart is split, found in
// the same traversal: clusters are made anew from the cells, as flood fill would, in every frame.
#include "clusters/passes/passes.h"

namespace {

class Decluster final : public dxCrossoverPass {
public:
    const char *name() const override { return "decluster"; }
    bool listsBigStatics() const override { return true; }
    bool splits() const override { return true; }
    void cross(const dxClusterScene &scene, const std::vector<Link> &links, const dxClusters &,
               dxClusters &clusters) override {
        dxClusterDynamics(scene, links, nullptr, m_memory, clusters);
        dxDuplicateStatics(scene, clusters);
    }
};

}  // namespace

std::unique_ptr<dxCrossoverPass> dxMakeDeclusterPass() { return std::make_unique<Decluster>(); }
