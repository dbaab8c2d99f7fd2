// Contacts as lanes (dxLanes.h): the contacts of a pair of bodies are a manifold, which is a lane of a pack.
//
// The unknowns of a contact are three impulses p: one along the normal, two along tangents, with p(normal) >= 0 and
// |p(tangent)| <= friction p(normal) + limit.
#pragma once

#include <cstdint>

#include "dynamics/quick_step/fast/dxLanes.h"

// One contact of each manifold. The members are in the order in which a sweep reads them: in another order sweeps took up to half as much
// time again where contacts fit no cache.
struct dxContactLanes {
    enum Row : unsigned { kNormal, kTangent, kSecondTangent, kRows };
    static constexpr unsigned kTangents = 2;

    dxLaneNumbers rA[3];                 // from the centre of body A to the contact
    dxLaneNumbers direction[kRows][3];   // normal and tangents: of the force on body A
    dxLaneNumbers bias[kRows];           // m/s
    dxLaneNumbers softness[kRows];       // cfm / step size
    dxLaneNumbers impulse[kRows];        // the answer
    dxLaneNumbers effectiveMass[kRows];  // 1 / (J inv(M) J' + softness)
    dxLaneNumbers coupling[kRows];       // J inv(M) J' between rows 0 and 1, 0 and 2, 1 and 2
    dxLaneNumbers friction[kTangents], limit[kTangents];
};

struct dxContactPack : dxLaneBodies {
    static constexpr unsigned kMaxContacts = 8;  // of a manifold; more contacts are another manifold

    dxLaneNumbers dAB[3];   // x(A) - x(B), so that rB = rA + dAB; 0 without body B
    unsigned firstContact;  // in the array of dxContactLanes
    unsigned contactCount;  // the largest number that a manifold of the pack has
};

// What an impulse of 1 along each of a contact's directions changes. Responses act between the contacts of one manifold only; the bodies' velocities
// come from the impulses.
struct dxContactResponse {
    dxLaneNumbers row[dxContactLanes::kRows][6];        // change of the bodies' relative motion
    dxLaneNumbers normal[dxContactPack::kMaxContacts];  // change of the residual of each normal of the pack
};

struct dxContactPacks {
    dxContactPack *packs;
    dxContactLanes *contacts;
    dxLaneNumbers *energies;       // by pack: the energy that a kernel finds for each manifold
    dxContactResponse *responses;  // by contact; null: none
};

// Contact joints that follow one another in a group of islands and act between the same two bodies.
struct dxContactManifold {
    static constexpr std::uint8_t kNoLane = dxLanes::kCount;

    unsigned firstJoint;
    std::uint8_t contactCount, color;
    std::uint8_t lane;  // kNoLane: its contacts are solved as rows
    bool firstOwns;     // of dxContactCache: body A keeps the forces for the next step
    unsigned pack;      // of a manifold in rows: its first contact's place in dxConstraintPlan::rowJoints(); the others follow
    int body[2];        // tags, or dxContactPack::kNoBody

    bool isInRows() const { return lane == kNoLane; }
    unsigned firstRowJoint() const { return pack; }
};
