#include "dynamics/quick_step/fast/dxContactReader.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include <ode/odemath.h>

#include "joints/contact.h"

#include "core/dxPrefetch.h"
#include "dynamics/quick_step/fast/dxFastQuickStepState.h"
#include "dynamics/quick_step/fast/dxStateNumbers.h"
#include "dynamics/step/islands/dxForBodies.h"
#include "dynamics/step/islands/dxIslandProblem.h"

namespace {

using Manifold = dxConstraintPlan::Manifold;

constexpr unsigned kPrefetchDistance = 3;  // manifolds

// Stands for an infinite coefficient, which allows any force even if the normal has none: upstream's limit is then 0 times infinity, which bounds
// nothing.
constexpr dReal kLargeFriction = dReal(1e30);

dReal velocityAlong(const dxBody &body, const dReal *direction, const dReal *rA) {
    dVector3 axis;
    dCalcVectorCross3(axis, rA, direction);
    return dCalcVectorDot3(direction, body.lvel) + dCalcVectorDot3(axis, body.avel);
}

// Returns the velocity that the normal asks for.
dReal pushOut(const dxIslandStep &step, const dxJointContact &joint, const dReal *normal, const dReal (&r)[2][3]) {
    const dxWorld &world = *step.world;
    const dSurfaceParameters &surface = joint.contact.surface;
    const dReal depth = std::max(joint.contact.geom.depth - world.contactp.min_depth, dReal(0));
    const dReal motion = (surface.mode & dContactMotionN) != 0 ? surface.motionN : dReal(0);
    const dReal bias = std::min(dRecip(step.stepSize) * dxContactErp(world, surface) * depth + motion, world.contactp.max_vel);
    if ((surface.mode & dContactBounce) == 0 || !(surface.bounce_vel >= 0)) return bias;
    dReal outgoing = velocityAlong(*joint.node[0].body, normal, r[0]);
    if (joint.node[1].body != nullptr) outgoing -= velocityAlong(*joint.node[1].body, normal, r[1]);
    const dReal incoming = motion - outgoing;
    return incoming > surface.bounce_vel ? std::max(bias, surface.bounce * incoming + motion) : bias;
}

// Reads the limits of one friction row. With limits of 0 the row has no force.
void readFriction(dReal coefficient, bool isOfNormal, dReal stepSize, unsigned tangent, unsigned lane, dxContactLanes &contact) {
    const bool isInfinite = coefficient >= kLargeFriction;
    const dReal finite = isInfinite ? kLargeFriction : coefficient > 0 ? coefficient : dReal(0);
    const bool follows = isOfNormal && !isInfinite;
    contact.friction[tangent].set(lane, follows ? finite : 0);
    contact.limit[tangent].set(lane, follows ? 0 : finite * stepSize);
}

// Returns the offset from the centre of one of the bodies to a contact: rA or rB.
dReal offsetOf(const dxContactPack &pack, const dxContactLanes &contact, bool isOfA, int axis, unsigned lane) {
    const dReal rA = static_cast<dReal>(contact.rA[axis].lane[lane]);
    return isOfA ? rA : rA + static_cast<dReal>(pack.dAB[axis].lane[lane]);
}

// Returns the impulse along an axis of the world.
dReal impulseAlong(const dxContactLanes &contact, int axis, unsigned lane) {
    dReal sum = 0;
    for (unsigned row = 0; row < dxContactLanes::kRows; ++row)
        sum += static_cast<dReal>(contact.direction[row][axis].lane[lane]) * static_cast<dReal>(contact.impulse[row].lane[lane]);
    return sum;
}

}  // namespace

dxContactReader::dxContactReader(const dxIslandStep &step, const dxIslandBody *bodies)
    : m_step(step), m_bodies(bodies), m_cache(step.fastQuickStep->cache()) {}

// Prefetches the joints of a manifold.
void dxContactReader::prefetchJoints(const Manifold *manifold) const {
    if (manifold == nullptr) return;
    for (unsigned k = 0; k < manifold->contactCount; ++k) dxIslandPrefetch::joint(m_step.island.joints[manifold->firstJoint + k]);
}

// Prefetches what startWarm() will look for, for the manifolds of a pack. It is at the end of a chain of three places in memory, of which eight
// are followed here side by side.
void dxContactReader::prefetchForces(const Manifold *const *lanes) const {
    for (unsigned lane = 0; lane < dxLanes::kCount; ++lane)
        if (lanes[lane] != nullptr)
            m_cache.forLast(numberOf(lanes[lane]->body[0]), numberOf(lanes[lane]->body[1]),
                             [this](const dxContactCache::Manifold &last, bool) {
                                 dxPrefetch::lines(m_cache.lastContacts(last),
                                                   last.contactCount * sizeof(dxContactCache::Contact));
                             });
}

bool dxContactReader::read(const dxContactPacks &contacts, Lanes lanes, unsigned begin, unsigned end) const {
    bool hasFeedback = false;
    const bool isLarge = m_step.island.bodyCount >= dxIslandPrefetch::kMinBodies;
    for (unsigned i = begin; i < end; ++i) {
        dxContactPack &pack = contacts.packs[i];
        const Manifold *const *const own = lanes.data() + i * dxLanes::kCount;
        if (isLarge && i + 1 < end) prefetchForces(own + dxLanes::kCount);
        std::memset(contacts.contacts + pack.firstContact, 0, pack.contactCount * sizeof(dxContactLanes));
        for (unsigned lane = 0; lane < dxLanes::kCount; ++lane) {
            pack.clear(lane, m_step.island.bodyCount);
            if (isLarge && i * dxLanes::kCount + lane + kPrefetchDistance < end * dxLanes::kCount)
                prefetchJoints(own[lane + kPrefetchDistance]);
            if (own[lane] == nullptr) continue;
            readBodies(pack, lane, *own[lane]);
            const ContactOrder order = orderOf(*own[lane]);
            for (unsigned i = 0; i < own[lane]->contactCount; ++i) {
                const dxJoint &joint = *m_step.island.joints[own[lane]->firstJoint + i];
                readContact(contacts.contacts[pack.firstContact + order.placeOf(i)], lane, joint);
                hasFeedback |= joint.feedback != nullptr;
            }
            startWarm(contacts, pack, lane, *own[lane]);
        }
    }
    return hasFeedback;
}

// Returns another order in each step, as long as bodies move. With one order the error of the sweeps has the same direction in each step, and a
// column of boxes tilts until it falls.
dxContactReader::ContactOrder dxContactReader::orderOf(const Manifold &manifold) const {
    const std::uint64_t bits = dxStateNumbers::bitsOf(m_step.island.bodies[manifold.body[0]]->posr.pos);
    return {manifold.contactCount, dxStateNumbers::below(bits, manifold.contactCount), (bits & 1) != 0};
}

void dxContactReader::readBodies(dxContactPack &pack, unsigned lane, const Manifold &manifold) const {
    pack.set(lane, manifold.body, m_bodies);
    if (manifold.body[1] == dxConstraintPlan::kNoBody) return;
    dVector3 dAB;
    dSubtractVectors3(dAB, m_step.island.bodies[manifold.body[0]]->posr.pos, m_step.island.bodies[manifold.body[1]]->posr.pos);
    dxSetLane(pack.dAB, lane, dAB);
}

void dxContactReader::readContact(dxContactLanes &contact, unsigned lane, const dxJoint &joint) const {
    const auto &own = static_cast<const dxJointContact &>(joint);
    const dSurfaceParameters &surface = own.contact.surface;
    const int mode = surface.mode;
    dReal normal[3], r[2][3] = {};
    for (int i = 0; i < 3; ++i) {
        normal[i] = (own.flags & dJOINT_REVERSE) != 0 ? -own.contact.geom.normal[i] : own.contact.geom.normal[i];
        r[0][i] = own.contact.geom.pos[i] - own.node[0].body->posr.pos[i];
        if (own.node[1].body != nullptr) r[1][i] = own.contact.geom.pos[i] - own.node[1].body->posr.pos[i];
    }
    dxSetLane(contact.rA, lane, r[0]);
    dxSetLane(contact.direction[dxContactLanes::kNormal], lane, normal);
    if ((mode & dContactFDir1) != 0) dxSetLane(contact.direction[dxContactLanes::kTangent], lane, own.contact.fdir1);

    contact.bias[0].set(lane, pushOut(m_step, own, normal, r));
    contact.bias[1].set(lane, (mode & dContactMotion1) != 0 ? surface.motion1 : 0);
    contact.bias[2].set(lane, (mode & dContactMotion2) != 0 ? surface.motion2 : 0);
    const dReal perStep = dRecip(m_step.stepSize), cfm = m_step.world->global_cfm;
    contact.softness[0].set(lane, perStep * ((mode & dContactSoftCFM) != 0 ? surface.soft_cfm : cfm));
    contact.softness[1].set(lane, perStep * ((mode & dContactSlip1) != 0 ? surface.slip1 : cfm));
    contact.softness[2].set(lane, perStep * ((mode & dContactSlip2) != 0 ? surface.slip2 : cfm));
    const dReal mu2 = (mode & dContactMu2) != 0 ? surface.mu2 : surface.mu;
    readFriction(surface.mu, (mode & dContactApprox1_1) != 0, m_step.stepSize, 0, lane, contact);
    readFriction(mu2, (mode & dContactApprox1_2) != 0, m_step.stepSize, 1, lane, contact);
}

void dxContactReader::startWarm(const dxContactPacks &contacts, const dxContactPack &pack, unsigned lane,
                                const Manifold &manifold) const {
    dxContactLanes *const own = contacts.contacts + pack.firstContact;
    m_cache.match(
        m_step, manifold,
        [&](unsigned k, bool isOfA, int axis) { return offsetOf(pack, own[k], isOfA, axis, lane); },
        [&](unsigned k, int axis) { return own[k].direction[dxContactLanes::kNormal][axis].lane[lane]; },
        [&](unsigned k, const dReal *impulse) {
            for (int axis = 0; axis < 3; ++axis)
                own[k].impulse[axis].set(lane, std::isfinite(impulse[axis]) ? impulse[axis] : 0);
        });
}

void dxContactReader::list(const dxConstraintPlan &plan) const {
    const unsigned firstJoint = m_cache.firstJoint(m_step.island);
    m_cache.clear(m_step.island);
    plan.forLaneManifolds([&](Manifold &manifold) {
        const unsigned firstContact = firstJoint + manifold.firstJoint;
        manifold.firstOwns =
            m_cache.keep(numberOf(manifold.body[0]), numberOf(manifold.body[1]), firstContact, manifold.contactCount);
    });
}

void dxContactReader::keep(const dxContactPacks &contacts, Lanes lanes, unsigned begin, unsigned end) const {
    const unsigned firstJoint = m_cache.firstJoint(m_step.island);
    const dReal perStep = dRecip(m_step.stepSize);
    for (unsigned i = begin; i < end; ++i)
        for (unsigned lane = 0; lane < dxLanes::kCount; ++lane) {
            const Manifold *const manifold = lanes[std::size_t(i) * dxLanes::kCount + lane];
            if (manifold == nullptr) continue;
            const dReal sign = manifold->firstOwns ? 1 : -1;
            dxContactCache::Contact *const kept = m_cache.contacts(firstJoint + manifold->firstJoint);
            const dxContactPack &pack = contacts.packs[i];
            for (unsigned k = 0; k < manifold->contactCount; ++k) {
                const dxContactLanes &contact = contacts.contacts[pack.firstContact + k];
                for (int axis = 0; axis < 3; ++axis) {
                    kept[k].r[axis] = static_cast<float>(offsetOf(pack, contact, manifold->firstOwns, axis, lane));
                    kept[k].normal[axis] = static_cast<float>(sign) * contact.direction[dxContactLanes::kNormal][axis].lane[lane];
                    kept[k].force[axis] = static_cast<float>(sign * perStep * impulseAlong(contact, axis, lane));
                }
            }
        }
}

bool dxContactReader::hasFeedback(const Manifold &manifold) const {
    const dxJoint *const *const first = m_step.island.joints + manifold.firstJoint;
    return std::any_of(first, first + manifold.contactCount, [](const dxJoint *joint) { return joint->feedback != nullptr; });
}

void dxContactReader::giveFeedback(const dxContactPacks &contacts, const dxConstraintPlan &plan) const {
    const dReal perStep = dRecip(m_step.stepSize);
    plan.forLaneManifolds([&](const Manifold &manifold) {
        if (!hasFeedback(manifold)) return;
        const ContactOrder order = orderOf(manifold);
        for (unsigned i = 0; i < manifold.contactCount; ++i) {
            const dxJoint &joint = *m_step.island.joints[manifold.firstJoint + i];
            if (joint.feedback == nullptr) continue;
            const dxContactPack &pack = contacts.packs[manifold.pack];
            const dxContactLanes &contact = contacts.contacts[pack.firstContact + order.placeOf(i)];
            dVector3 force = {}, r[2] = {};
            for (int axis = 0; axis < 3; ++axis) {
                force[axis] = impulseAlong(contact, axis, manifold.lane) * perStep;
                r[0][axis] = offsetOf(pack, contact, true, axis, manifold.lane);
                r[1][axis] = offsetOf(pack, contact, false, axis, manifold.lane);
            }
            dJointFeedback &feedback = *joint.feedback;
            dCopyVector3(feedback.f1, force);
            dCalcVectorCross3(feedback.t1, r[0], force);
            if (joint.node[1].body == nullptr) continue;
            dCopyNegatedVector3(feedback.f2, force);
            dCalcVectorCross3(feedback.t2, force, r[1]);
        }
    });
}
