// The contact forces of a world's last step, from which the next one starts (warm start).
//
// Contacts have no identity: a program makes them anew for every step. A contact gets the force of one of the last step's between
// the same two bodies, the nearest one whose normal is alike. "Near" is meant in arms, from the centre of one of the bodies in
// the world's axes, since these stay the same while a sphere rolls or a stack is carried along.
//
// Bodies are recognised without addresses, which may be another body's by now: bits of dxBody::flags that upstream does not use
// hold a body's number in the last step, and a new body has none. That number leads to the contacts that the body then owned; of
// two bodies the one with the fewer contacts owns those between them, so that a hub with thousands of them has a short list.
//
// Threading: begin() before a step, on its thread; groups of a step may be read and written at the same time.
#pragma once

#include <cstddef>
#include <vector>

#include "dynamics/step/islands/dxIsland.h"

class dxContactForces {
public:
    struct Contact {
        float arm[3], normal[3];  // the owner's centre to the contact; of the force on the owner
        float force[3];           // on the owner
    };

    // Contacts [firstContact, firstContact + contactCount) are between the owner and another body, or the static environment.
    struct Manifold {
        unsigned other;  // a body's number; kNone
        unsigned firstContact, contactCount;
        unsigned next;  // of the owner; kNone
    };

    static constexpr unsigned kNone = ~0u;

    // A step begins. Throws std::bad_alloc, and is then cold. `isWarm`: what the last step found may be used.
    void begin(const dxWorldProcessIslandsInfo &info, bool isWarm);

    // Calls visit(manifold, ownerIsFirst) for all that the last step found between two bodies of this one.
    // `first`, `second`: their numbers in this step; the second may be kNone.
    template <class Visit>
    void forLast(unsigned first, unsigned second, const Visit &visit) const {
        const unsigned lastFirst = m_lastNumber[first], lastSecond = second == kNone ? kNone : m_lastNumber[second];
        if (lastFirst != kNone && (second == kNone || lastSecond != kNone)) forOwned(lastFirst, lastSecond, true, visit);
        if (lastSecond != kNone && lastFirst != kNone) forOwned(lastSecond, lastFirst, false, visit);
    }

    const Contact *lastContacts(const Manifold &manifold) const { return m_last.contacts.data() + manifold.firstContact; }

    // Where a group's bodies and joints begin.
    unsigned firstBody(const dxIsland &group) const { return static_cast<unsigned>(group.bodies - m_bodies); }
    unsigned firstJoint(const dxIsland &group) const { return static_cast<unsigned>(group.joints - m_joints); }

    // `tag`: of a body of the group, or dxContactPack::kNoBody.
    unsigned numberOf(const dxIsland &group, int tag) const {
        return tag < 0 ? kNone : firstBody(group) + static_cast<unsigned>(tag);
    }

    // Nothing is kept of this step for a group any more. A group may be stepped twice: what an interruption leaves is taken back.
    void clear(const dxIsland &group);

    // Keeps a manifold of this step, which is known by its first contact. Returns whether the first body owns it.
    bool keep(unsigned first, unsigned second, unsigned firstContact, unsigned contactCount);
    Contact *contacts(unsigned firstContact) { return m_now.contacts.data() + firstContact; }

private:
    struct Body {
        const dxBody *body;
        unsigned firstManifold, manifoldCount;
    };

    struct Step {
        std::vector<Body> bodies;
        std::vector<Manifold> manifolds;
        std::vector<Contact> contacts;
    };

    // A list that has become longer all the same is not walked to its end.
    static constexpr unsigned kMaxLookedAt = 64;

    template <class Visit>
    void forOwned(unsigned owner, unsigned other, bool ownerIsFirst, const Visit &visit) const {
        unsigned left = kMaxLookedAt;
        for (unsigned i = m_last.bodies[owner].firstManifold; i != kNone && left != 0; i = m_last.manifolds[i].next, --left)
            if (m_last.manifolds[i].other == other) visit(m_last.manifolds[i], ownerIsFirst);
    }

    void numberBodies(unsigned bodyCount);

    Step m_last, m_now;
    std::vector<unsigned> m_lastNumber;  // by body of this step; kNone
    dxBody *const *m_bodies = nullptr;
    dxJoint *const *m_joints = nullptr;
};
