#include "dynamics/quick_step/fast/dxContactReader.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include <ode/odemath.h>

#include "joints/contact.h"

#include "core/dxPrefetch.h"
#include "dynamics/quick_step/fast/dxContactErp.h"
#include "dynamics/quick_step/fast/dxContactMatch.h"
#include "dynamics/quick_step/fast/dxIterativeWorld.h"
#include "dynamics/quick_step/fast/dxStateNumbers.h"
#include "dynamics/step/islands/dxIslandPrefetch.h"

namespace {

using Manifold = dxConstraintPlan::Manifold;

constexpr unsigned kPrefetchDistance = 3;  // manifolds

// Stands for an infinite coefficient. That allows any force, even if the normal has none: upstream's limit is then 0 times infinity,
// which bounds nothing.
constexpr dReal kLargeFriction = dReal(1e30);

void write(const dReal *vector, dxLaneNumbers *numbers, unsigned lane) {
    for (int i = 0; i < 3; ++i) numbers[i].lane[lane] = vector[i];
}

dReal velocityAlong(const dxBody &body, const dReal *direction, const dReal *arm) {
    dVector3 axis;
    dCalcVectorCross3(axis, arm, direction);
    return dCalcVectorDot3(direction, body.lvel) + dCalcVectorDot3(axis, body.avel);
}

// The velocity that the normal asks for.
dReal pushOut(const dxIslandStep &step, const dxJointContact &joint, const dReal *normal, const dReal (&arm)[2][3]) {
    const dxWorld &world = *step.world;
    const dSurfaceParameters &surface = joint.contact.surface;
    const dReal depth = std::max(joint.contact.geom.depth - world.contactp.min_depth, dReal(0));
    const dReal motion = (surface.mode & dContactMotionN) != 0 ? surface.motionN : dReal(0);
    const dReal wanted = std::min(dRecip(step.stepSize) * dxContactErp(world, surface) * depth + motion, world.contactp.max_vel);
    if ((surface.mode & dContactBounce) == 0 || !(surface.bounce_vel >= 0)) return wanted;
    dReal outgoing = velocityAlong(*joint.node[0].body, normal, arm[0]);
    if (joint.node[1].body != nullptr) outgoing -= velocityAlong(*joint.node[1].body, normal, arm[1]);
    const dReal incoming = motion - outgoing;
    return incoming > surface.bounce_vel ? std::max(wanted, surface.bounce * incoming + motion) : wanted;
}

// The limits of one friction row. None: the row has no force.
void readFriction(dReal coefficient, bool isOfNormal, dReal stepSize, unsigned tangent, unsigned lane, dxContactLanes &contact) {
    const bool isInfinite = coefficient >= kLargeFriction;
    const dReal finite = isInfinite ? kLargeFriction : coefficient > 0 ? coefficient : dReal(0);
    const bool follows = isOfNormal && !isInfinite;
    contact.friction[tangent].lane[lane] = follows ? finite : 0;
    contact.limit[tangent].lane[lane] = follows ? 0 : finite * stepSize;
}

// From the centre of one of the bodies to a contact.
dReal armOf(const dxContactPack &pack, const dxContactLanes &contact, bool isOfFirst, int axis, unsigned lane) {
    const dReal arm = contact.arm[axis].lane[lane];
    return isOfFirst ? arm : arm + pack.between[axis].lane[lane];
}

// The impulse along an axis of the world.
dReal impulseAlong(const dxContactLanes &contact, int axis, unsigned lane) {
    dReal sum = 0;
    for (unsigned row = 0; row < dxContactLanes::kRows; ++row)
        sum += contact.direction[row][axis].lane[lane] * contact.impulse[row].lane[lane];
    return sum;
}

}  // namespace

dxContactReader::dxContactReader(const dxIslandStep &step, const dxIslandBody *bodies)
    : m_step(step), m_bodies(bodies), m_forces(step.iterativeWorld->forces()) {}

// Joints of a manifold that comes next.
void dxContactReader::prefetchJoints(const Manifold *manifold) const {
    if (manifold == nullptr) return;
    for (unsigned k = 0; k < manifold->contactCount; ++k) dxIslandPrefetch::joint(m_step.island.joints[manifold->firstJoint + k]);
}

// What startWarm() will look for, for a pack's manifolds. Each is at the end of a chain of three places in memory; here eight chains
// are followed side by side.
void dxContactReader::prefetchForces(const Manifold *const *lanes) const {
    for (unsigned lane = 0; lane < dxLanes::kCount; ++lane)
        if (lanes[lane] != nullptr)
            m_forces.forLast(numberOf(lanes[lane]->body[0]), numberOf(lanes[lane]->body[1]),
                             [this](const dxContactForces::Manifold &last, bool) {
                                 dxPrefetch::lines(m_forces.lastContacts(last),
                                                   last.contactCount * sizeof(dxContactForces::Contact));
                             });
}

bool dxContactReader::read(const dxContactPacks &contacts, const Manifold *const *lanes, unsigned begin, unsigned end) const {
    bool hasFeedback = false;
    const bool isLarge = m_step.island.bodyCount >= dxIslandPrefetch::kMinBodies;
    for (unsigned i = begin; i < end; ++i) {
        dxContactPack &pack = contacts.packs[i];
        const Manifold *const *const own = lanes + i * dxLanes::kCount;
        if (isLarge && i + 1 < end) prefetchForces(own + dxLanes::kCount);
        std::memset(contacts.contacts + pack.firstContact, 0, pack.contactCount * sizeof(dxContactLanes));
        for (unsigned lane = 0; lane < dxLanes::kCount; ++lane) {
            for (int side = 0; side < 2; ++side) {
                pack.source[side][lane] = static_cast<int>(m_step.island.bodyCount);
                pack.target[side][lane] = dxContactPack::kNoBody;
            }
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

// Another one in each step, as long as bodies move. What sweeps have not found would otherwise point the same way each time, and a column of
// boxes tilt until it falls.
dxContactReader::ContactOrder dxContactReader::orderOf(const Manifold &manifold) const {
    const std::uint64_t bits = dxStateNumbers::bitsOf(m_step.island.bodies[manifold.body[0]]->posr.pos);
    return {manifold.contactCount, dxStateNumbers::below(bits, manifold.contactCount), (bits & 1) != 0};
}

void dxContactReader::readBodies(dxContactPack &pack, unsigned lane, const Manifold &manifold) const {
    constexpr int kElements[6] = {0, 1, 2, 4, 5, 8};
    for (int side = 0; side < 2; ++side) {
        if (manifold.body[side] == dxConstraintPlan::kNoBody) continue;
        const dxIslandBody &body = m_bodies[manifold.body[side]];
        pack.source[side][lane] = manifold.body[side];
        if (!(body.invMass > 0)) continue;
        pack.target[side][lane] = manifold.body[side];
        pack.inverseMass[side].lane[lane] = body.invMass;
        for (int i = 0; i < 6; ++i) pack.inverseInertia[side][i].lane[lane] = body.invInertia[kElements[i]];
    }
    if (manifold.body[1] == dxConstraintPlan::kNoBody) return;
    dVector3 between;
    dSubtractVectors3(between, m_step.island.bodies[manifold.body[0]]->posr.pos, m_step.island.bodies[manifold.body[1]]->posr.pos);
    write(between, pack.between, lane);
}

void dxContactReader::readContact(dxContactLanes &contact, unsigned lane, const dxJoint &joint) const {
    const auto &own = static_cast<const dxJointContact &>(joint);
    const dSurfaceParameters &surface = own.contact.surface;
    const int mode = surface.mode;
    dReal normal[3], arm[2][3] = {};
    for (int i = 0; i < 3; ++i) {
        normal[i] = (own.flags & dJOINT_REVERSE) != 0 ? -own.contact.geom.normal[i] : own.contact.geom.normal[i];
        arm[0][i] = own.contact.geom.pos[i] - own.node[0].body->posr.pos[i];
        if (own.node[1].body != nullptr) arm[1][i] = own.contact.geom.pos[i] - own.node[1].body->posr.pos[i];
    }
    write(arm[0], contact.arm, lane);
    write(normal, contact.direction[0], lane);
    if ((mode & dContactFDir1) != 0) write(own.contact.fdir1, contact.direction[1], lane);

    contact.wanted[0].lane[lane] = pushOut(m_step, own, normal, arm);
    contact.wanted[1].lane[lane] = (mode & dContactMotion1) != 0 ? surface.motion1 : 0;
    contact.wanted[2].lane[lane] = (mode & dContactMotion2) != 0 ? surface.motion2 : 0;
    const dReal perStep = dRecip(m_step.stepSize), cfm = m_step.world->global_cfm;
    contact.softness[0].lane[lane] = perStep * ((mode & dContactSoftCFM) != 0 ? surface.soft_cfm : cfm);
    contact.softness[1].lane[lane] = perStep * ((mode & dContactSlip1) != 0 ? surface.slip1 : cfm);
    contact.softness[2].lane[lane] = perStep * ((mode & dContactSlip2) != 0 ? surface.slip2 : cfm);
    const dReal mu2 = (mode & dContactMu2) != 0 ? surface.mu2 : surface.mu;
    readFriction(surface.mu, (mode & dContactApprox1_1) != 0, m_step.stepSize, 0, lane, contact);
    readFriction(mu2, (mode & dContactApprox1_2) != 0, m_step.stepSize, 1, lane, contact);
}

void dxContactReader::startWarm(const dxContactPacks &contacts, const dxContactPack &pack, unsigned lane,
                                const Manifold &manifold) const {
    dxContactLanes *const own = contacts.contacts + pack.firstContact;
    dxMatchContacts(
        m_forces, m_step, manifold,
        [&](unsigned k, bool isOfFirst, int axis) { return armOf(pack, own[k], isOfFirst, axis, lane); },
        [&](unsigned k, int axis) { return own[k].direction[0][axis].lane[lane]; },
        [&](unsigned k, const dReal *impulse) {
            for (int axis = 0; axis < 3; ++axis)
                own[k].impulse[axis].lane[lane] = std::isfinite(impulse[axis]) ? impulse[axis] : 0;
        });
}

void dxContactReader::list(std::vector<Manifold> &manifolds) const {
    const unsigned firstJoint = m_forces.firstJoint(m_step.island);
    m_forces.clear(m_step.island);
    for (Manifold &manifold : manifolds) {
        const unsigned firstContact = firstJoint + manifold.firstJoint;
        manifold.firstOwns =
            m_forces.keep(numberOf(manifold.body[0]), numberOf(manifold.body[1]), firstContact, manifold.contactCount);
    }
}

void dxContactReader::keep(const dxContactPacks &contacts, const Manifold *const *lanes, unsigned begin, unsigned end) const {
    const unsigned firstJoint = m_forces.firstJoint(m_step.island);
    const dReal perStep = dRecip(m_step.stepSize);
    for (unsigned i = begin; i < end; ++i)
        for (unsigned lane = 0; lane < dxLanes::kCount; ++lane) {
            const Manifold *const manifold = lanes[i * dxLanes::kCount + lane];
            if (manifold == nullptr) continue;
            const dReal sign = manifold->firstOwns ? 1 : -1;
            dxContactForces::Contact *const kept = m_forces.contacts(firstJoint + manifold->firstJoint);
            const dxContactPack &pack = contacts.packs[i];
            for (unsigned k = 0; k < manifold->contactCount; ++k) {
                const dxContactLanes &contact = contacts.contacts[pack.firstContact + k];
                for (int axis = 0; axis < 3; ++axis) {
                    kept[k].arm[axis] = static_cast<float>(armOf(pack, contact, manifold->firstOwns, axis, lane));
                    kept[k].normal[axis] = static_cast<float>(sign * contact.direction[0][axis].lane[lane]);
                    kept[k].force[axis] = static_cast<float>(sign * perStep * impulseAlong(contact, axis, lane));
                }
            }
        }
}

bool dxContactReader::hasFeedback(const Manifold &manifold) const {
    const dxJoint *const *const first = m_step.island.joints + manifold.firstJoint;
    return std::any_of(first, first + manifold.contactCount, [](const dxJoint *joint) { return joint->feedback != nullptr; });
}

void dxContactReader::giveFeedback(const dxContactPacks &contacts, const std::vector<Manifold> &manifolds) const {
    const dReal perStep = dRecip(m_step.stepSize);
    for (const Manifold &manifold : manifolds) {
        if (!hasFeedback(manifold)) continue;
        const ContactOrder order = orderOf(manifold);
        for (unsigned i = 0; i < manifold.contactCount; ++i) {
            const dxJoint &joint = *m_step.island.joints[manifold.firstJoint + i];
            if (joint.feedback == nullptr) continue;
            const dxContactPack &pack = contacts.packs[manifold.pack];
            const dxContactLanes &contact = contacts.contacts[pack.firstContact + order.placeOf(i)];
            dVector3 force = {}, arm[2] = {};
            for (int axis = 0; axis < 3; ++axis) {
                force[axis] = impulseAlong(contact, axis, manifold.lane) * perStep;
                arm[0][axis] = armOf(pack, contact, true, axis, manifold.lane);
                arm[1][axis] = armOf(pack, contact, false, axis, manifold.lane);
            }
            dJointFeedback &feedback = *joint.feedback;
            dCopyVector3(feedback.f1, force);
            dCalcVectorCross3(feedback.t1, arm[0], force);
            if (joint.node[1].body == nullptr) continue;
            dCopyNegatedVector3(feedback.f2, force);
            dCalcVectorCross3(feedback.t2, force, arm[1]);
        }
    }
}
