#include "dynamics/quick_step/fast/dxRowContacts.h"

#include "joints/contact.h"

#include "dynamics/quick_step/fast/dxContactMatch.h"
#include "dynamics/quick_step/fast/dxIterativeWorld.h"
#include "dynamics/quick_step/fast/dxOtherRows.h"

using Manifold = dxConstraintPlan::Manifold;

dxRowContacts::dxRowContacts(const dxIslandStep &step, dxConstraintPlan &plan)
    : m_step(step), m_manifolds(plan.rowManifolds()), m_forces(step.iterativeWorld->forces()) {}

dReal dxRowContacts::armOf(unsigned joint, bool isOfFirst, int axis) const {
    const auto &contact = static_cast<const dxJointContact &>(*m_step.island.joints[joint]);
    return contact.contact.geom.pos[axis] - contact.node[isOfFirst ? 0 : 1].body->posr.pos[axis];
}

dReal dxRowContacts::normalOf(unsigned joint, int axis) const {
    const auto &contact = static_cast<const dxJointContact &>(*m_step.island.joints[joint]);
    const dReal normal = contact.contact.geom.normal[axis];
    return (contact.flags & dJOINT_REVERSE) != 0 ? -normal : normal;
}

void dxRowContacts::start(dxOtherRows &rows) const {
    for (const Manifold &manifold : m_manifolds)
        dxMatchContacts(
            m_forces, m_step, manifold,
            [&](unsigned k, bool isOfFirst, int axis) { return armOf(manifold.firstJoint + k, isOfFirst, axis); },
            [&](unsigned k, int axis) { return normalOf(manifold.firstJoint + k, axis); },
            [&](unsigned k, const dReal *impulse) { rows.startContact(manifold.firstOther() + k, impulse); });
}

void dxRowContacts::keep(const dxOtherRows &rows) const {
    const unsigned firstJoint = m_forces.firstJoint(m_step.island);
    const dReal perStep = dRecip(m_step.stepSize);
    for (Manifold &manifold : m_manifolds) {
        const unsigned firstContact = firstJoint + manifold.firstJoint;
        manifold.firstOwns =
            m_forces.keep(m_forces.numberOf(m_step.island, manifold.body[0]), m_forces.numberOf(m_step.island, manifold.body[1]),
                          firstContact, manifold.contactCount);
        const dReal sign = manifold.firstOwns ? 1 : -1;
        for (unsigned k = 0; k < manifold.contactCount; ++k) {
            dVector3 impulse;
            rows.findContactImpulse(manifold.firstOther() + k, impulse);
            dxContactForces::Contact &kept = m_forces.contacts(firstContact)[k];
            for (int axis = 0; axis < 3; ++axis) {
                kept.arm[axis] = static_cast<float>(armOf(manifold.firstJoint + k, manifold.firstOwns, axis));
                kept.normal[axis] = static_cast<float>(sign * normalOf(manifold.firstJoint + k, axis));
                kept.force[axis] = static_cast<float>(sign * perStep * impulse[axis]);
            }
        }
    }
}
