// The contacts between two bodies, or a body and what does not move: contact joints that follow one another in a group of islands.
#pragma once

#include <cstdint>
#include <vector>

#include "dynamics/quick_step/fast/dxContactPack.h"

struct dxContactManifold {
    unsigned firstJoint;
    std::uint8_t contactCount, color;
    std::uint8_t lane;
    bool firstOwns;  // of dxContactForces: the first body keeps the forces for the next step
    unsigned pack;   // of a manifold in rows: its first one of dxConstraintPlan::otherJoints(); its contacts follow one another there
    int body[2];     // tags, or dxContactPack::kNoBody

    unsigned firstOther() const { return pack; }
};

// `body`: a tag, or dxContactPack::kNoBody; `moves`: by tag.
inline bool dxDoesMove(int body, const std::vector<std::uint8_t> &moves) {
    return body != dxContactPack::kNoBody && moves[static_cast<unsigned>(body)] != 0;
}
