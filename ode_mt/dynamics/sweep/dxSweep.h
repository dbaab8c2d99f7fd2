// QuickStep's sweep over the rows of an island (successive over-relaxation), which takes most of its time.
// ode/seams/quickstep.h puts it in the place of upstream's; docs/sweep.md tells why the bits are the same.
#pragma once

#include <ode/common.h>

// What a sweep needs of a row beside its Jacobian, side by side. A row of a large island is fetched from afar, and costs
// four lines of the cache this way; in upstream's arrays it touches seven.
struct alignas(64) dxSweepRow {
    dReal impulse[12];
    dReal lambda;
    int body[2];
    int boundingRow;
};

// The arrays of an island as upstream lays them out. No row acts on one body twice (dJointAttach refuses
// such joints), and a bounding row is one of the same joint.
struct dxSweepIsland {
    enum JacobianColumn { kBody1 = 0, kRhs = 6, kCfm = 7, kBody2 = 8, kLow = 14, kHigh = 15, kJacobianColumns = 16 };
    enum ImpulseColumn { kOn1 = 0, kOn2 = 6, kImpulseColumns = 12 };
    static constexpr unsigned kForceColumns = 6;
    static constexpr int kNone = -1;

    unsigned rows;
    unsigned bodies;
    const dReal *jacobian;   // rows x 16; columns 8 to 13 are unset if there is no second body
    const dReal *impulse;    // rows x 12: inv(M) J^T, the change of `force` for a change of lambda by one
    const int *bodiesOfRow;  // rows x 2; the second may be kNone
    const int *boundingRow;  // rows: the limits are the high one times the lambda of this row; or kNone
    dReal *lambda;           // rows
    dReal *force;            // bodies x 6
    dxSweepRow *packed = nullptr;  // rows, in the place of `impulse`, `boundingRow` and `lambda`, if it is set

    // From so many rows on, which is about the second cache, packing pays for itself.
    static constexpr unsigned kLarge = 1000;
};

// `order` and `level`: as many elements as there are rows; `work`: as many as there are rows or bodies,
// whichever is more. Only `order` is a result.
struct dxSweepSchedule {
    int *order;
    unsigned *level;
    unsigned *work;
};

// Finds an order of the rows that gives the results of `order` and in which neighbours seldom wait for one
// another. Worth its time for rows in the order of their joints, not for shuffled ones.
void dxScheduleSweep(const dxSweepIsland &island, const int *order, const dxSweepSchedule &schedule);

// Takes every row once, in this order.
void dxSweep(const dxSweepIsland &island, const int *order);
