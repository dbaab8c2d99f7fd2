// An island: bodies connected by enabled joints. Islands of one step share no body and no joint, which
// is why they may be stepped at the same time. Upstream's island search finds them and fixes their order
// and the order within them.
#pragma once

#include <ode/ode.h>

#include "config.h"
#include "objects.h"
#include "joints/joint.h"
#include "util.h"

struct dxIsland {
    dxBody *const *bodies;
    dxJoint *const *joints;
    unsigned bodyCount;
    unsigned jointCount;
};

// Walks the islands of a step in order.
class dxIslandCursor {
public:
    explicit dxIslandCursor(const dxWorldProcessIslandsInfo &info)
        : m_sizes(info.GetIslandSizes()), m_bodies(info.GetBodiesArray()), m_joints(info.GetJointsArray()) {}

    dxIsland next() {
        const dxIsland island{m_bodies, m_joints, m_sizes[0], m_sizes[1]};
        m_bodies += island.bodyCount;
        m_joints += island.jointCount;
        m_sizes += 2;
        return island;
    }

private:
    const unsigned *m_sizes;  // upstream's layout: bodies, joints of each island
    dxBody *const *m_bodies;
    dxJoint *const *m_joints;
};
