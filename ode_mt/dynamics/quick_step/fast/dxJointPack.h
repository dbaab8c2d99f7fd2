// Joints as lanes (dxLanes.h): joints other than contacts, each a lane of a pack, with all of their rows.
//
// Of all joints in lanes the force on B is the opposite of that on A; their torques have nothing in common.
#pragma once

#include "dynamics/quick_step/fast/dxLanes.h"

// One row of each joint.
struct dxJointLanes {
    dxLaneNumbers linear[3];      // of the force on body A
    dxLaneNumbers angular[3];     // of the torque on body A
    dxLaneNumbers together[3];    // of the torques on A and B: what the row says of bodies that turn together
    dxLaneNumbers bias;           // m/s, or 1/s
    dxLaneNumbers softness;       // cfm / step size
    dxLaneNumbers low, high;      // of the impulse
    dxLaneNumbers impulse;        // the answer
    dxLaneNumbers effectiveMass;  // 1 / (J inv(M) J' + softness)
};

struct dxJointPack : dxLaneBodies {
    unsigned firstRow;  // in the array of dxJointLanes
    unsigned rowCount;  // the largest number that a joint of the pack has
};

struct dxJointPacks {
    dxJointPack *packs;
    dxJointLanes *rows;
    dxLaneNumbers *energies;  // by pack: the energy that a kernel finds for each joint
};
