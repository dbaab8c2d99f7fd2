// The constraint problem of one island, as plain data: the input of a solver, and its answer.
//
// Symbols, as in upstream's manual: J the Jacobian, M the bodies' masses, h the step size, v and f the velocities and
// external forces before the step. A solver finds multipliers lambda, one for each row, with
//
//   (J inv(M) J' + cfm) lambda = rhs - J (v / h + inv(M) f)
//
// as far as their bounds [low, high] allow. The bounds of a row that another row bounds (friction) are +- |high| times
// that row's lambda.
//
// Layout: a row is one block of four cache lines (in double precision), in the form in which a sweep reads it, whatever the size of the
// island. All arrays together fit the memory that upstream estimates for an island, byte for byte (dxQuickStep.cpp).
#pragma once

#include <ode/common.h>

#include <cstddef>

struct dxConstraintRow {
    enum Column { kBody1 = 0, kRhs = 6, kCfm = 7, kBody2 = 8, kLow = 14, kHigh = 15, kColumns = 16 };
    static constexpr int kBodyColumns = 6;
    static constexpr int kNone = -1;
    static constexpr unsigned kMaxOfJoint = 6;  // rows

    // Of the problem. Joints write `jacobian` (dxJoint::getInfo2): linear and angular columns for each body.
    dReal jacobian[kColumns];

    // Of the solver: inv(M) J', the change of a body's acceleration for a change of lambda by one. Each begins where a vector of
    // four does not cross a cache line.
    dReal impulseOn1[kBodyColumns];
    dReal lambda;     // the answer
    int body[2];      // indices; the second may be kNone, and its columns are undefined then
    dReal impulseOn2[kBodyColumns];
    int boundingRow;  // an earlier row of the same joint, or kNone

    // Of dxScheduleSor alone.
    unsigned level, levelBegin;

    bool hasSecondBody() const { return body[1] != kNone; }
    // Returns whether the bounds follow another row's lambda, as those of friction follow the normal (upstream's findex).
    bool hasFrictionIndex() const { return boundingRow != kNone; }
};

// A body's masses in the world's frame, side by side for the rows that act on it.
struct dxIslandBody {
    dReal invInertia[9];  // by rows
    dReal invMass;

    // inv(M) J', of a row's columns for the body. The order of sums is upstream's.
    void respond(const dReal *jacobian, dReal *impulse) const {
        for (int i = 0; i < 3; ++i) {
            const dReal *const inertia = invInertia + 3 * i;
            impulse[i] = invMass * jacobian[i];
            impulse[3 + i] = inertia[0] * jacobian[3] + inertia[1] * jacobian[4] + inertia[2] * jacobian[5];
        }
    }
};

// The motion of a body while constraints are solved, linear, then angular: what they add to its acceleration (exact; m/s2, 1/s2), or its
// velocity (fast; m/s, 1/s). One cache line (in double precision), since every row that acts on the body reads and writes it.
struct alignas(8 * sizeof(dReal)) dxSpatialMotion {
    dReal columns[dxConstraintRow::kBodyColumns];
    unsigned level;  // of dxScheduleSor alone
};

struct dxIslandProblem {
    unsigned rowCount;
    unsigned bodyCount;
    dxConstraintRow *rows;
    dxIslandBody *bodies;
    // By body. Given: -(v / h + inv(M) f), which is missing in the rows' right-hand sides. Answer: inv(M) J' lambda.
    dxSpatialMotion *accelerations;
    int *order;  // rowCount: room for the solver

    dReal *accelerationOf(int body) const { return accelerations[body].columns; }

    // From this number of rows on they do not fit L2, and prefetching pays.
    static constexpr unsigned kLarge = 1000;
    bool isLarge() const { return rowCount >= kLarge; }
};
