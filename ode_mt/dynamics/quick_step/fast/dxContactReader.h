// Contact joints as lanes: writes what upstream's dxJointContact::getInfo2 says of a contact, so far as it is not the same for
// all rows, into packs; dxPrepareContacts makes the rest from it, a lane for each contact. Afterwards it reads answers from
// there.
//
// Equations are upstream's: erp, cfm, depth, layers, bounce, slip, motion, friction pyramids by force or by the normal's force.
//
// Threading: each pack may be read and written on its own; feedback is the caller's.
#pragma once

#include "dynamics/quick_step/fast/dxConstraintPlan.h"
#include "dynamics/quick_step/fast/dxContactForces.h"
#include "dynamics/quick_step/fast/dxContactSweep.h"
#include "dynamics/step/islands/dxIslandStep.h"

struct dxIslandBody;

class dxContactReader {
public:
    // `bodies`: masses, by tag.
    dxContactReader(const dxIslandStep &step, const dxIslandBody *bodies);

    // Writes packs [begin, end) and their contacts. `lanes`: manifolds by pack and lane; null: none. Returns whether a joint asks for
    // feedback.
    bool read(const dxContactPacks &contacts, const dxConstraintPlan::Manifold *const *lanes, unsigned begin, unsigned end) const;

    // Makes places for the forces that the next step begins with, and then keeps them there, of packs [begin, end).
    void list(std::vector<dxConstraintPlan::Manifold> &manifolds) const;
    void keep(const dxContactPacks &contacts, const dxConstraintPlan::Manifold *const *lanes, unsigned begin, unsigned end) const;

    // Writes forces to the joints' feedback, in the order of joints.
    void giveFeedback(const dxContactPacks &contacts, const std::vector<dxConstraintPlan::Manifold> &manifolds) const;

private:
    // The contacts of a manifold from any of them on, forth or back.
    struct ContactOrder {
        unsigned count, start;
        bool isReversed;

        // Of its joint i.
        unsigned placeOf(unsigned i) const { return (count + (isReversed ? start - i : i - start)) % count; }
    };

    ContactOrder orderOf(const dxConstraintPlan::Manifold &manifold) const;
    bool hasFeedback(const dxConstraintPlan::Manifold &manifold) const;
    unsigned numberOf(int tag) const { return m_forces.numberOf(m_step.island, tag); }
    void prefetchJoints(const dxConstraintPlan::Manifold *manifold) const;
    void prefetchForces(const dxConstraintPlan::Manifold *const *lanes) const;
    void readBodies(dxContactPack &pack, unsigned lane, const dxConstraintPlan::Manifold &manifold) const;
    void readContact(dxContactLanes &contact, unsigned lane, const dxJoint &joint) const;
    void startWarm(const dxContactPacks &contacts, const dxContactPack &pack, unsigned lane,
                   const dxConstraintPlan::Manifold &manifold) const;

    const dxIslandStep &m_step;
    const dxIslandBody *const m_bodies;
    dxContactForces &m_forces;
};
