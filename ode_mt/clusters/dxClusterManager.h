// Gives spaces their clusters: those that collide while a clustered algorithm is in force. The name is the thesis's, whose
// manager owned a hidden world and space for each cluster; this one owns nothing.
//
// The clusters of a world and space belong to the space (dxClusterBroadphase is its broad phase), so
// they are found through it in O(1) and are destroyed with it.
#pragma once

#include <ode/ode.h>

class dxClusteredWorldAndSpace;

class dxClusterManager {
public:
    // Requires a call before a space collides. Gives it clusters under the pass of that name, or removes them if the name is
    // NULL. A locked space keeps those that it has.
    static void prepare(dSpaceID space, const char *passName);

    // Returns NULL if the space has no clusters.
    static const dxClusteredWorldAndSpace *find(dSpaceID space);
};
