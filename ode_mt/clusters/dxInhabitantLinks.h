// Which members of a space belong together wherever they are: geoms of one body, and of bodies with a joint
// between them. Read from upstream's lists of geoms and joints, so every joint that was made or broken is known at once.
#pragma once

#include <utility>
#include <vector>

#include <ode/ode.h>

#include "clusters/dxClusterScene.h"
#include "clusters/dxCrossoverPass.h"
#include "collision/pairs/dxMembers.h"

// Returns dynamic if the geom, or a geom in it, has a body.
dxClusterScene::Kind dxKindOf(const dxGeom *geom);

class dxInhabitantLinks {
public:
    using Link = dxCrossoverPass::Link;

    // Returns whether the links differ from those of the last call.
    bool gather(const dxMembers &members, const dxClusterScene &scene);

    const std::vector<Link> &all() const { return m_links; }  // sorted

private:
    using Slot = dxMembers::Slot;
    using BodySlot = std::pair<const dxBody *, Slot>;

    void linkGeomsOfBodies();
    void linkJointedBodies();

    std::vector<BodySlot> m_bodies;  // sorted
    std::vector<Link> m_links, m_before;
};
