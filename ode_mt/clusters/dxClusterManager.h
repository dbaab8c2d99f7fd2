// Which spaces have clusters: those that collide while a cluster algorithm is in force. The name is the thesis's, whose
// manager owned a hidden world and space for each cluster; this one owns nothing.
//
// The clusters of a world and space belong to the space (dxClusterBroadphase is its broad phase), so
// they are found through it in O(1), there are as many as there are spaces, and they go with it.
#pragma once

#include <ode/ode.h>

class dxClusteredWorldAndSpace;

class dxClusterManager {
public:
    // Before a space collides: gives it clusters under the pass of that name, or takes them away, if it is
    // NULL. A locked space keeps what it has.
    static void prepare(dSpaceID space, const char *passName);

    // NULL: the space has no clusters.
    static const dxClusteredWorldAndSpace *find(dSpaceID space);
};
