// Contacts as lanes: eight manifolds that share no moving body, side by side, so that one vector operation serves all of them.
//
// A manifold is the contacts between two bodies. Its unknowns are impulses p (force times step size): of each contact one along
// the normal, two along tangents. A row of the constraint asks for J u + softness p = wanted, u being the bodies' velocities at
// the end of the step, as far as the limits allow: p(normal) >= 0, |p(tangent)| <= friction p(normal) + limit.
//
// Lanes without a manifold, and contacts that a manifold has less than its pack, are zero everywhere, and so do nothing.
#pragma once

#include <ode/common.h>

struct dxLanes {
    static constexpr unsigned kCount = 8;  // a cache line, and the widest vector, in double precision
};

// One number of each manifold.
struct alignas(dxLanes::kCount * sizeof(dReal)) dxLaneNumbers {
    dReal lane[dxLanes::kCount];
};

// One contact of each manifold. In the order in which a sweep reads it: where contacts do not fit caches, another one has taken up
// to half as much time again.
struct dxContactLanes {
    static constexpr unsigned kRows = 3, kTangents = 2;  // normal, two tangents

    dxLaneNumbers arm[3];               // from the first body's centre to the contact
    dxLaneNumbers direction[kRows][3];  // of the force on the first body
    dxLaneNumbers wanted[kRows];        // m/s
    dxLaneNumbers softness[kRows];      // cfm / step size
    dxLaneNumbers impulse[kRows];       // the answer
    dxLaneNumbers inverse[kRows];       // 1 / (J inv(M) J' + softness)
    dxLaneNumbers coupling[kRows];      // of rows 0 and 1, 0 and 2, 1 and 2: J inv(M) J'
    dxLaneNumbers friction[kTangents], limit[kTangents];
};

struct dxContactPack {
    static constexpr unsigned kMaxContacts = 8;  // of a manifold; more are a manifold of their own
    static constexpr int kNoBody = -1;

    dxLaneNumbers inverseMass[2];
    dxLaneNumbers inverseInertia[2][6];  // in the world's frame: xx, xy, xz, yy, yz, zz
    dxLaneNumbers between[3];            // from the second body's centre to the first one's; 0 where there is one body
    int source[2][dxLanes::kCount];      // where a body's velocity is read
    int target[2][dxLanes::kCount];      // where it is written; kNoBody for bodies that do not move
    unsigned firstContact;               // of the array of dxContactLanes
    unsigned contactCount;               // the most that a manifold of the pack has
};

// What an impulse of 1 along each of a contact's directions changes. Between the contacts of a manifold alone, for which a float's digits
// suffice: the bodies' velocities come from the impulses.
struct dxContactResponse {
    struct alignas(dxLanes::kCount * sizeof(float)) Numbers {
        float lane[dxLanes::kCount];
    };
    Numbers row[dxContactLanes::kRows][6];        // of the bodies' relative motion
    Numbers normal[dxContactPack::kMaxContacts];  // along the normal: of what each normal of the pack lacks
};

struct dxContactPacks {
    dxContactPack *packs;
    dxContactLanes *contacts;
    dxLaneNumbers *energies;       // by pack: what a kernel has found of each manifold
    dxContactResponse *responses;  // by contact; or none
};
