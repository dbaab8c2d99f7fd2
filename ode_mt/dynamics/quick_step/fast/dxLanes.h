// Lanes: sixteen constraints that share no moving body, side by side, so that one vector operation serves all of them.
//
// A constraint is between body A and body B, or between body A and the static environment. Its rows ask for J u + softness p = bias, as far as their
// limits allow; u are the bodies' velocities at the end of the step, the unknowns p impulses (force times step size). Numbers of lanes without a
// constraint are zero, and so are those of rows that a constraint has fewer than its pack. Both do nothing.
//
// Numbers are floats: rows differ from the joints' by 6e-8 of their size, while what sweeps leave is more than a thousand times as much. The bodies'
// velocities, to which all impulses add up, are of dReal.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#include <ode/common.h>

#include "dynamics/step/islands/dxIslandProblem.h"

struct dxLanes {
    static constexpr unsigned kCount = 16;  // a cache line, and the widest vector

    static constexpr std::size_t packsOf(std::size_t constraints) { return (constraints + kCount - 1) / kCount; }
};

// One number of each constraint of a pack.
struct alignas(dxLanes::kCount * sizeof(float)) dxLaneNumbers {
    float lane[dxLanes::kCount];

    // A number beyond the largest float becomes that one. NaN stays NaN.
    void set(unsigned index, dReal number) {
        constexpr dReal kLargest = std::numeric_limits<float>::max();
        lane[index] = static_cast<float>(std::clamp(number, -kLargest, kLargest));
    }
};

inline void dxSetLane(dxLaneNumbers *numbers, unsigned lane, const dReal *vector) {
    for (int i = 0; i < 3; ++i) numbers[i].set(lane, vector[i]);
}

// The bodies A and B of the constraints of a pack.
struct dxLaneBodies {
    static constexpr int kNoBody = -1;

    dxLaneNumbers inverseMass[2];        // of A, of B
    dxLaneNumbers inverseInertia[2][6];  // in the world's frame: xx, xy, xz, yy, yz, zz
    int source[2][dxLanes::kCount];      // where a body's velocity is read
    int target[2][dxLanes::kCount];      // where it is written; kNoBody for bodies that do not move

    // `rest`: where the velocity of a body at rest is read.
    void clear(unsigned lane, unsigned rest) {
        for (int side = 0; side < 2; ++side) {
            source[side][lane] = static_cast<int>(rest);
            target[side][lane] = kNoBody;
        }
    }

    // `body`: tags, or kNoBody; `masses`: by tag. Requires clear().
    void set(unsigned lane, const int (&body)[2], const dxIslandBody *masses) {
        constexpr int kElements[6] = {0, 1, 2, 4, 5, 8};
        for (int side = 0; side < 2; ++side) {
            if (body[side] == kNoBody) continue;
            const dxIslandBody &own = masses[body[side]];
            source[side][lane] = body[side];
            if (!(own.invMass > 0)) continue;
            target[side][lane] = body[side];
            inverseMass[side].set(lane, own.invMass);
            for (int i = 0; i < 6; ++i) inverseInertia[side][i].set(lane, own.invInertia[kElements[i]]);
        }
    }
};
