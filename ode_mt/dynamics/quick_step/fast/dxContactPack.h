// Contacts as lanes: sixteen manifolds that share no moving body, side by side, so that one vector operation serves all of them.
//
// A manifold is the contacts between body A and body B, or between body A and the static environment. The unknowns of a contact are three
// impulses p (force times step size): one along the normal, two along tangents. A row of the constraint asks for J u + softness p = bias, as far
// as its limits allow: p(normal) >= 0, |p(tangent)| <= friction p(normal) + limit. u are the bodies' velocities at the end of the step.
//
// Numbers of lanes without a manifold are zero, and so are those of contacts that a manifold has fewer than its pack. Both do nothing.
//
// Numbers are floats: rows differ from the joints' by 6e-8 of their size, while what sweeps leave is more than a thousand times as much. The bodies'
// velocities, to which all impulses add up, are of dReal.
#pragma once

#include <cstdint>

#include <ode/common.h>

struct dxLanes {
    static constexpr unsigned kCount = 16;  // a cache line, and the widest vector
};

// One number of each manifold of a pack.
struct alignas(dxLanes::kCount * sizeof(float)) dxLaneNumbers {
    float lane[dxLanes::kCount];
};

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

struct dxContactPack {
    static constexpr unsigned kMaxContacts = 8;  // of a manifold; more contacts are another manifold
    static constexpr int kNoBody = -1;

    dxLaneNumbers inverseMass[2];        // of A, of B
    dxLaneNumbers inverseInertia[2][6];  // in the world's frame: xx, xy, xz, yy, yz, zz
    dxLaneNumbers dAB[3];                // x(A) - x(B), so that rB = rA + dAB; 0 without body B
    int source[2][dxLanes::kCount];      // where a body's velocity is read
    int target[2][dxLanes::kCount];      // where it is written; kNoBody for bodies that do not move
    unsigned firstContact;               // in the array of dxContactLanes
    unsigned contactCount;               // the largest number that a manifold of the pack has
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
