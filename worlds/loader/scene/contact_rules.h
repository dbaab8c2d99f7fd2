// Which pairs of geoms may touch, and how.
#pragma once

#include "loader/description/world_description.h"

#include <ode/ode.h>

#include <deque>
#include <optional>
#include <vector>

namespace worlds {

class ContactRules {
public:
    explicit ContactRules(const WorldDescription &world)
        : m_frictionPyramid(world.physics.frictionPyramid), m_staticMeetsStatic(world.staticMeetsStatic) {}

    // Makes the geom known: its data pointer, category and collide bits are set.
    void add(dGeomID geom, const Link &link, const Collision &collision);

    // The geom's friction direction turns with that body instead. Requires a geom that was added.
    static void setFrictionFrame(dGeomID geom, dBodyID body);

    // False for bodies joined by a joint, for bodies of one model unless one of them wants to touch the
    // rest of it, and for two static geoms. Those do not even get here, by their bits, unless the world
    // says staticMeetsStatic.
    static bool mayTouch(dGeomID geom1, dGeomID geom2);

    // At most this many contacts become joints.
    static int maxContacts(dGeomID geom1, dGeomID geom2);

    // The surface parameters of a pair: the friction and bounce of the weaker of the two, the
    // softness of the softer.
    dSurfaceParameters surface(dGeomID geom1, dGeomID geom2) const;

    // Completes a contact whose geom and surface are set: the first friction direction.
    static void setDirection(dContact &contact);

private:
    struct Properties {
        Surface surface;
        int maxContacts;
        int model;
        bool selfCollide;
        std::optional<Quaternion> rotation;  // of a static shape; ODE has none of planes, and another one of height fields
        dBodyID frictionFrame = nullptr;  // null: the geom itself
    };
    static const Properties &of(dGeomID geom);
    static Vector3 frictionDirection(dGeomID geom);  // in the world; it has to have one

    bool m_frictionPyramid, m_staticMeetsStatic;
    std::deque<Properties> m_properties;  // the geoms point here
};

// Numbers of the `limit` deepest of the first `count` contacts, in their own order. Of equally deep
// ones the earlier is taken.
std::vector<int> deepestContacts(const std::vector<dContact> &contacts, int count, int limit);

}  // namespace worlds
