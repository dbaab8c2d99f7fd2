// Contact joints to lanes, and forces back: writes what upstream's dxJointContact::getInfo2 says of a contact into packs, as far as it is not the
// same for all rows; dxPrepareContacts makes the rest from it, a lane for each contact. Afterwards it reads the answers.
//
// The equations are upstream's: erp, cfm, depth, layers, bounce, slip, motion, friction pyramids by force or by the normal's force.
//
// Threading: several threads may read and keep different packs at the same time; all else is serial.
#pragma once

#include "dynamics/quick_step/fast/dxConstraintPlan.h"
#include "dynamics/quick_step/fast/dxContactCache.h"
#include "dynamics/quick_step/fast/dxContactPack.h"
#include "dynamics/step/islands/dxIslandStep.h"

struct dxIslandBody;

class dxContactReader {
public:
    // The manifold in each lane of each pack; null: none.
    using Lanes = dxArenaArray<const dxConstraintPlan::Manifold *const>;

    // `bodies`: masses, by tag.
    dxContactReader(const dxIslandStep &step, const dxIslandBody *bodies);

    // Writes packs [begin, end) and their contacts. Returns whether a joint asks for feedback.
    bool read(const dxContactPacks &contacts, Lanes lanes, unsigned begin, unsigned end) const;

    // Drops what the warm-start cache has of this step for the group, and makes places for the manifolds in lanes.
    void list(const dxConstraintPlan &plan) const;

    // Leaves the forces of packs [begin, end) in these places. Requires list().
    void keep(const dxContactPacks &contacts, Lanes lanes, unsigned begin, unsigned end) const;

    // Writes forces to the joints' feedback, in the order of joints.
    void giveFeedback(const dxContactPacks &contacts, const dxConstraintPlan &plan) const;

private:
    // The order in which the contacts of a manifold are solved: from any of them on, forwards or backwards.
    struct ContactOrder {
        unsigned count, start;
        bool isReversed;

        // Returns the place of the manifold's joint i.
        unsigned placeOf(unsigned i) const { return (count + (isReversed ? start - i : i - start)) % count; }
    };

    ContactOrder orderOf(const dxConstraintPlan::Manifold &manifold) const;
    bool hasFeedback(const dxConstraintPlan::Manifold &manifold) const;
    unsigned numberOf(int tag) const { return m_cache.numberOf(m_step.island, tag); }
    void prefetchJoints(const dxConstraintPlan::Manifold *manifold) const;
    void prefetchForces(const dxConstraintPlan::Manifold *const *lanes) const;
    void readBodies(dxContactPack &pack, unsigned lane, const dxConstraintPlan::Manifold &manifold) const;
    void readContact(dxContactLanes &contact, unsigned lane, const dxJoint &joint) const;
    void startWarm(const dxContactPacks &contacts, const dxContactPack &pack, unsigned lane,
                   const dxConstraintPlan::Manifold &manifold) const;

    const dxIslandStep &m_step;
    const dxIslandBody *const m_bodies;
    dxContactCache &m_cache;
};
