#include "dynamics/dxIslandSurvey.h"

#include <algorithm>

bool dxHasMovedCallback(const dxIsland &island) {
    return std::any_of(island.bodies, island.bodies + island.bodyCount,
                       [](const dxBody *body) { return body->moved_callback != nullptr; });
}

unsigned dxCountRows(const dxIsland &island) {
    unsigned rows = 0;
    for (unsigned i = 0; i < island.jointCount; ++i) {
        dxJoint::Info1 info;
        island.joints[i]->getInfo1(&info);
        rows += info.m;
    }
    return rows;
}

void dxCollectFeedback(const dxIsland &island, unsigned index, std::vector<dxFeedbackUse> &uses) {
    for (unsigned i = 0; i < island.jointCount; ++i) {
        if (const dJointFeedback *feedback = island.joints[i]->feedback) uses.push_back({feedback, index});
    }
}
