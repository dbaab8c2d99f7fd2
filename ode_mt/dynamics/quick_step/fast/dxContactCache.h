// The warm-start cache: the contact forces of a world's last step, from which the next step starts.
//
// Contacts have no identity: a program makes them anew for every step. A contact gets the force of a contact of the last step between
// the same two bodies: the nearest one whose normal is similar. Distances are between offsets from the centre of one of the bodies, in the
// world's axes, since these stay the same while a sphere rolls or a stack is carried along.
//
// Bodies are recognised without their addresses, which may belong to another body by now: bits of dxBody::flags that upstream does not use
// hold a body's number in the last step, and a new body has none. The number leads to the contacts that the body then owned. Of two bodies
// the one with fewer contacts owns those between them, so that a hub with thousands of contacts has a short list.
//
// Threading: begin() is called before a step, on its thread; groups of a step may be read and written at the same time.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "joints/contact.h"

#include "dynamics/quick_step/fast/dxContactPack.h"
#include "dynamics/step/islands/dxIslandStep.h"

class dxContactCache {
public:
    struct Contact {
        float r[3], normal[3];  // from the owner's centre to the contact; of the force on the owner
        float force[3];         // on the owner
    };

    // Contacts [firstContact, firstContact + contactCount) are between the owner and another body, or the static environment.
    struct Manifold {
        unsigned other;  // a body's number; kNone
        unsigned firstContact, contactCount;
        unsigned next;  // of the owner; kNone
    };

    static constexpr unsigned kNone = ~0u;

    // Begins a step. Throws std::bad_alloc, and is cold then. `isWarm`: what the last step found may be used.
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

    // Calls give(number, impulse on body A) for contacts of the manifold: the part of the last step's forces with which this step begins, in
    // the world's axes. A contact of the last step is used once: by the nearest contact that has none yet, in the order of the manifold.
    //
    // offsetOf(number, whether from body A's centre, axis), normalOf(number, axis): of the manifold's contacts.
    template <class OffsetOf, class NormalOf, class Give>
    void match(const dxIslandStep &step, const dxContactManifold &manifold, const OffsetOf &offsetOf, const NormalOf &normalOf,
               const Give &give) const;

    // Where a group's bodies and joints begin.
    unsigned firstBody(const dxIsland &group) const { return static_cast<unsigned>(group.bodies - m_bodies); }
    unsigned firstJoint(const dxIsland &group) const { return static_cast<unsigned>(group.joints - m_joints); }

    // `tag`: of a body of the group, or dxContactPack::kNoBody.
    unsigned numberOf(const dxIsland &group, int tag) const {
        return tag < 0 ? kNone : firstBody(group) + static_cast<unsigned>(tag);
    }

    // Drops what was kept of this step for a group: after an interruption a group may be stepped twice.
    void clear(const dxIsland &group);

    // Keeps a manifold of this step, which is identified by its first contact. Returns whether the first body owns it.
    bool keep(unsigned first, unsigned second, unsigned firstContact, unsigned contactCount);
    Contact *contacts(unsigned firstContact) { return m_now.contacts.data() + firstContact; }

    // Whether forces of a step of the size `last` are good for one of the size `stepSize`. With steps of two sizes in turns, six boxes fall
    // that stand without kept forces: at a ratio of 3 one column in twelve, of 4 all of them; at 2 they move more.
    static bool isSimilar(dReal stepSize, dReal last) { return stepSize < kMaxRatio * last && last < kMaxRatio * stepSize; }

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

    struct Candidate {
        const Contact *contact;
        bool firstOwns;
    };

    static constexpr dReal kMaxRatio = dReal(1.75);

    // A longer list is not searched to its end.
    static constexpr unsigned kMaxVisited = 64;

    // The smallest cosine between the normals of one contact in two steps.
    static constexpr float kMinCosine = 0.9f;

    // The largest number of contacts of the last step that are compared for a manifold.
    static constexpr unsigned kMaxCandidates = 32;

    template <class Visit>
    void forOwned(unsigned owner, unsigned other, bool ownerIsFirst, const Visit &visit) const {
        unsigned left = kMaxVisited;
        for (unsigned i = m_last.bodies[owner].firstManifold; i != kNone && left != 0; i = m_last.manifolds[i].next, --left)
            if (m_last.manifolds[i].other == other) visit(m_last.manifolds[i], ownerIsFirst);
    }

    void numberBodies(unsigned bodyCount);

    Step m_last, m_now;
    std::vector<unsigned> m_lastNumber;  // by body of this step; kNone
    dxBody *const *m_bodies = nullptr;
    dxJoint *const *m_joints = nullptr;
};

// Returns how much of a contact's depth one step corrects.
inline dReal dxContactErp(const dxWorld &world, const dSurfaceParameters &surface) {
    return (surface.mode & dContactSoftERP) != 0 ? surface.soft_erp : world.global_erp;
}

// Returns with how much of a contact's or joint's last force a step begins. Three quarters: full warm starting lowers the residual but keeps stacks
// moving, and 0.75 damps them (docs/fast.md, "Warm start"). Less above an erp of 0.2, the default: a force that has corrected much
// of a contact's depth should not act again. With three quarters of all forces columns of six boxes move more from erp 0.25 on, and fall with 0.8.
dReal dxWarmStartFactor(dReal erp);

template <class OffsetOf, class NormalOf, class Give>
void dxContactCache::match(const dxIslandStep &step, const dxContactManifold &manifold, const OffsetOf &offsetOf, const NormalOf &normalOf,
                           const Give &give) const {
    Candidate candidates[kMaxCandidates];
    unsigned count = 0;
    forLast(numberOf(step.island, manifold.body[0]), numberOf(step.island, manifold.body[1]), [&](const Manifold &last, bool firstOwns) {
        const Contact *const own = lastContacts(last);
        for (unsigned i = 0; i < last.contactCount && count < kMaxCandidates; ++i) candidates[count++] = {own + i, firstOwns};
    });
    for (unsigned k = 0; k < manifold.contactCount && count != 0; ++k) {
        unsigned best = count;
        float nearest = HUGE_VALF;
        for (unsigned i = 0; i < count; ++i) {
            const Candidate &candidate = candidates[i];
            const float sign = candidate.firstOwns ? 1.0f : -1.0f;
            float distance = 0, cosine = 0;
            for (int axis = 0; axis < 3; ++axis) {
                const auto r = static_cast<float>(offsetOf(k, candidate.firstOwns, axis));
                const float difference = r - candidate.contact->r[axis];
                distance += difference * difference;
                cosine += sign * static_cast<float>(normalOf(k, axis)) * candidate.contact->normal[axis];
            }
            if (!(cosine > kMinCosine) || !(distance < nearest)) continue;
            nearest = distance;
            best = i;
        }
        if (best == count) continue;
        const auto &joint = static_cast<const dxJointContact &>(*step.island.joints[manifold.firstJoint + k]);
        const dReal part = dxWarmStartFactor(dxContactErp(*step.world, joint.contact.surface));
        const dReal scale = part * (candidates[best].firstOwns ? step.stepSize : -step.stepSize);
        dReal impulse[3];
        for (int axis = 0; axis < 3; ++axis) impulse[axis] = scale * static_cast<dReal>(candidates[best].contact->force[axis]);
        give(k, impulse);
        candidates[best] = candidates[--count];
    }
}
