// Which contact of the last step is which one of this step.
//
// Threading: reads what the last step has left; any thread.
#pragma once

#include <cmath>

#include "joints/contact.h"

#include "dynamics/quick_step/fast/dxConstraintPlan.h"
#include "dynamics/quick_step/fast/dxContactErp.h"
#include "dynamics/quick_step/fast/dxContactForces.h"
#include "dynamics/quick_step/fast/dxWarmStart.h"
#include "dynamics/step/islands/dxIslandStep.h"

namespace dxContactMatch {

// Normals of one contact in two steps are no farther apart.
constexpr float kAlike = 0.9f;

// Of a pair's contacts in the last step no more are looked at.
constexpr unsigned kMaxCandidates = 32;

struct Candidate {
    const dxContactForces::Contact *contact;
    bool firstOwns;
};

}  // namespace dxContactMatch

// Calls give(number, impulse on the first body) for the manifold's contacts: that part of the last step's forces, in the world's axes,
// with which this one begins. Each contact of the last step is used once: by the contact that is nearest to it of those that have none
// yet.
//
// armOf(number, whether from the first body's centre, axis), normalOf(number, axis): of the manifold's contacts.
template <class ArmOf, class NormalOf, class Give>
void dxMatchContacts(const dxContactForces &forces, const dxIslandStep &step, const dxConstraintPlan::Manifold &manifold,
                     const ArmOf &armOf, const NormalOf &normalOf, const Give &give) {
    using namespace dxContactMatch;
    Candidate candidates[kMaxCandidates];
    unsigned count = 0;
    forces.forLast(forces.numberOf(step.island, manifold.body[0]), forces.numberOf(step.island, manifold.body[1]),
                   [&](const dxContactForces::Manifold &last, bool firstOwns) {
                       const dxContactForces::Contact *const own = forces.lastContacts(last);
                       for (unsigned i = 0; i < last.contactCount && count < kMaxCandidates; ++i)
                           candidates[count++] = {own + i, firstOwns};
                   });
    for (unsigned k = 0; k < manifold.contactCount && count != 0; ++k) {
        unsigned best = count;
        float nearest = HUGE_VALF;
        for (unsigned i = 0; i < count; ++i) {
            const Candidate &candidate = candidates[i];
            const float sign = candidate.firstOwns ? 1.0f : -1.0f;
            float distance = 0, cosine = 0;
            for (int axis = 0; axis < 3; ++axis) {
                const auto arm = static_cast<float>(armOf(k, candidate.firstOwns, axis));
                const float difference = arm - candidate.contact->arm[axis];
                distance += difference * difference;
                cosine += sign * static_cast<float>(normalOf(k, axis)) * candidate.contact->normal[axis];
            }
            if (!(cosine > kAlike) || !(distance < nearest)) continue;
            nearest = distance;
            best = i;
        }
        if (best == count) continue;
        const auto &joint = static_cast<const dxJointContact &>(*step.island.joints[manifold.firstJoint + k]);
        const dReal part = dxWarmStart::partFor(dxContactErp(*step.world, joint.contact.surface));
        const dReal scale = part * (candidates[best].firstOwns ? step.stepSize : -step.stepSize);
        dReal impulse[3];
        for (int axis = 0; axis < 3; ++axis) impulse[axis] = scale * static_cast<dReal>(candidates[best].contact->force[axis]);
        give(k, impulse);
        candidates[best] = candidates[--count];
    }
}
