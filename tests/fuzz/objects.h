// The objects that a script has made, by their names. Those that ODE has destroyed are known to be gone.
#pragma once

#include "call.h"

#include <ode/ode.h>

#include <set>
#include <vector>

#include "scenes/scene.h"

namespace fuzz {

class Objects {
public:
    // The next number of its kind, unless a script that is read gives it.
    Reference add(ObjectKind kind, void *object, int number = -1);
    void *find(const Reference &reference) const;  // NULL: there is no such object, or no more
    // -1: unknown.
    int numberOf(ObjectKind kind, const void *object) const;

    // Those that live, oldest first.
    std::vector<Reference> living(ObjectKind kind) const;
    int countLiving(ObjectKind kind) const;
    // An upper limit of the names given.
    int named(ObjectKind kind) const { return static_cast<int>(m_objects[static_cast<int>(kind)].size()); }

    // Before ODE destroys them: what goes with them is forgotten, too.
    void forget(ObjectKind kind, const void *object);
    void forgetSpace(dSpaceID space);  // with what is in it, if it cleans up
    void forgetGeom(dGeomID geom);     // also a space
    void forgetWorld(dWorldID world);
    void forgetGroup(dJointGroupID group, bool isDestroyed);

    // A joint that was made in a group, or in a world.
    void putJoint(dJointID joint, dWorldID world, dJointGroupID group);
    dWorldID worldOf(dJointID joint) const;
    bool isInGroup(dJointID joint) const;

    // Data that a geom has, or a geom within a transform.
    bool isInUse(const void *data) const;
    void pinData(dGeomID geom);  // it goes into a transform

    // What the recorder's fields are read of.
    scenes::Inventory inventory() const;

private:
    struct JointHome {
        dJointID joint;
        dWorldID world;
        dJointGroupID group;
    };

    std::vector<void *> m_objects[objectKinds];  // NULL: gone
    std::vector<JointHome> m_homes;
    std::set<const void *> m_pinned;
};

}  // namespace fuzz
