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

// One contact of each manifold.
struct dxContactLanes {
    static constexpr unsigned kRows = 3, kTangents = 2;  // normal, two tangents

    dxLaneNumbers arm[2][3];            // from each body's centre to the contact
    dxLaneNumbers direction[kRows][3];  // of the force on the first body
    dxLaneNumbers coupling[kRows];      // of rows 0 and 1, 0 and 2, 1 and 2: J inv(M) J'
    dxLaneNumbers inverse[kRows];       // 1 / (J inv(M) J' + softness)
    dxLaneNumbers wanted[kRows];        // m/s
    dxLaneNumbers softness[kRows];      // cfm / step size
    dxLaneNumbers impulse[kRows];       // the answer
    dxLaneNumbers friction[kTangents], limit[kTangents];
};

struct dxContactPack {
    static constexpr unsigned kMaxContacts = 8;  // of a manifold; more are a manifold of their own
    static constexpr int kNoBody = -1;

    dxLaneNumbers inverseMass[2];
    dxLaneNumbers inverseInertia[2][6];  // in the world's frame: xx, xy, xz, yy, yz, zz
    int source[2][dxLanes::kCount];      // where a body's velocity is read
    int target[2][dxLanes::kCount];      // where it is written; kNoBody for bodies that do not move
    unsigned firstContact;               // of the array of dxContactLanes
    unsigned contactCount;               // the most that a manifold of the pack has
};
