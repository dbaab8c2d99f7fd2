#include "contact_rows.h"

#include <algorithm>
#include <cmath>

namespace quality {

namespace {

struct Arms {
    int body[2];
    dVector3 arm[2];  // from the bodies to the contact
};

// A force along `axis` on the first body, and against it on the second.
ConstraintRow linearRow(const Arms &arms, const dReal *axis) {
    ConstraintRow row;
    for (int side = 0; side < 2; ++side) {
        row.body[side] = arms.body[side];
        if (row.body[side] == ConstraintRow::kNone) continue;
        const double sign = side == 0 ? 1 : -1;
        dVector3 moment;
        dCalcVectorCross3(moment, arms.arm[side], axis);
        for (int i = 0; i < 3; ++i) {
            row.jacobian[side][i] = sign * axis[i];
            row.jacobian[side][3 + i] = sign * moment[i];
        }
    }
    return row;
}

ConstraintRow angularRow(const Arms &arms, const dReal *axis) {
    ConstraintRow row;
    for (int side = 0; side < 2; ++side) {
        row.body[side] = arms.body[side];
        if (row.body[side] == ConstraintRow::kNone) continue;
        for (int i = 0; i < 3; ++i) row.jacobian[side][3 + i] = side == 0 ? axis[i] : -axis[i];
    }
    return row;
}

// J v of the row with the velocities before the step.
double velocityBefore(const ConstraintRow &row, const std::vector<dBodyID> &bodies) {
    double sum = 0;
    for (int side = 0; side < 2; ++side) {
        if (row.body[side] == ConstraintRow::kNone) continue;
        const dBodyID body = bodies[std::size_t(row.body[side])];
        for (int i = 0; i < 3; ++i)
            sum += row.jacobian[side][i] * dBodyGetLinearVel(body)[i] + row.jacobian[side][3 + i] * dBodyGetAngularVel(body)[i];
    }
    return sum;
}

// The velocity at which the bodies should separate: out of one another, or bouncing.
double separationVelocity(const SavedContact &saved, const RowContext &context, const ConstraintRow &normal) {
    const dSurfaceParameters &surface = saved.contact.surface;
    const auto has = [&](int mode) { return (surface.mode & mode) != 0; };
    const dReal erp = has(dContactSoftERP) ? surface.soft_erp : dWorldGetERP(context.world);
    const dReal depth = std::max(dReal(0), saved.contact.geom.depth - dWorldGetContactSurfaceLayer(context.world));
    const dReal motion = has(dContactMotionN) ? surface.motionN : 0;
    double velocity = std::min(erp * depth / context.stepSize + motion, dWorldGetContactMaxCorrectingVel(context.world));
    if (has(dContactBounce) && surface.bounce_vel >= 0) {
        const double incoming = motion - velocityBefore(normal, context.bodies);
        if (incoming > surface.bounce_vel) velocity = std::max(velocity, surface.bounce * incoming + motion);
    }
    return velocity;
}

}  // namespace

void appendContactRows(const SavedContact &saved, const RowContext &context, std::vector<ConstraintRow> &rows) {
    const dContact &contact = saved.contact;
    const dSurfaceParameters &surface = contact.surface;
    const auto has = [&](int mode) { return (surface.mode & mode) != 0; };

    // A joint whose first body is the static world is turned round.
    const bool isReversed = saved.body[0] == ConstraintRow::kNone;
    Arms arms;
    arms.body[0] = saved.body[isReversed ? 1 : 0];
    arms.body[1] = saved.body[isReversed ? 0 : 1];
    dVector3 axis[3];  // two tangents, normal
    for (int i = 0; i < 3; ++i) axis[2][i] = isReversed ? -contact.geom.normal[i] : contact.geom.normal[i];
    if (has(dContactFDir1)) {
        std::copy_n(contact.fdir1, 3, axis[0]);
        dCalcVectorCross3(axis[1], axis[2], axis[0]);
    } else {
        dPlaneSpace(axis[2], axis[0], axis[1]);
    }
    for (int side = 0; side < 2; ++side)
        if (arms.body[side] != ConstraintRow::kNone)
            for (int i = 0; i < 3; ++i)
                arms.arm[side][i] = contact.geom.pos[i] - dBodyGetPosition(context.bodies[std::size_t(arms.body[side])])[i];

    const int normalRow = int(rows.size());
    const double worldCfm = dWorldGetCFM(context.world);
    ConstraintRow normal = linearRow(arms, axis[2]);
    normal.c = separationVelocity(saved, context, normal);
    normal.cfm = has(dContactSoftCFM) ? surface.soft_cfm : worldCfm;
    normal.low = 0;
    rows.push_back(normal);

    const dReal friction[2] = {surface.mu, has(dContactMu2) ? surface.mu2 : surface.mu};
    const int proportional[3] = {dContactApprox1_1, dContactApprox1_2, dContactApprox1_N};
    const auto limit = [&](ConstraintRow row, dReal most, int direction) {
        row.low = -most;
        row.high = most;
        if (has(proportional[direction])) row.normalRow = normalRow;
        rows.push_back(row);
    };
    for (int i = 0; i < 2; ++i) {
        if (!(friction[i] > 0)) continue;
        ConstraintRow row = linearRow(arms, axis[i]);
        row.c = has(i == 0 ? dContactMotion1 : dContactMotion2) ? (i == 0 ? surface.motion1 : surface.motion2) : 0;
        row.cfm = has(i == 0 ? dContactSlip1 : dContactSlip2) ? (i == 0 ? surface.slip1 : surface.slip2) : worldCfm;
        limit(row, friction[i], i);
    }
    if (!has(dContactRolling)) return;
    const dReal rolling[3] = {surface.rho, has(dContactAxisDep) ? surface.rho2 : surface.rho,
                              has(dContactAxisDep) ? surface.rhoN : surface.rho};
    for (int i = 0; i < 3; ++i) {
        if (!(rolling[i] > 0)) continue;
        ConstraintRow row = angularRow(arms, axis[i]);
        row.cfm = worldCfm;
        limit(row, rolling[i], i);
    }
}

void readContactForces(const dJointFeedback &feedback, ConstraintRow *first, ConstraintRow *end) {
    // Torque that linear rows do not explain is that of rolling friction.
    double rest[3] = {feedback.t1[0], feedback.t1[1], feedback.t1[2]};
    const auto isLinear = [](const ConstraintRow &row) {
        return row.jacobian[0][0] != 0 || row.jacobian[0][1] != 0 || row.jacobian[0][2] != 0;
    };
    for (ConstraintRow *row = first; row != end; ++row) {
        if (!isLinear(*row)) continue;
        row->force = 0;
        for (int i = 0; i < 3; ++i) row->force += row->jacobian[0][i] * feedback.f1[i];
        for (int i = 0; i < 3; ++i) rest[i] -= row->jacobian[0][3 + i] * row->force;
    }
    for (ConstraintRow *row = first; row != end; ++row) {
        if (isLinear(*row)) continue;
        row->force = 0;
        for (int i = 0; i < 3; ++i) row->force += row->jacobian[0][3 + i] * rest[i];
    }
}

}  // namespace quality
