#include "joint_rows.h"

#include <algorithm>
#include <cmath>

namespace quality {

namespace {

int placeOf(dBodyID body, const std::vector<dBodyID> &bodies) {
    const auto found = std::find(bodies.begin(), bodies.end(), body);
    return found == bodies.end() ? ConstraintRow::kNone : int(found - bodies.begin());
}

struct Pair {
    dBodyID handle[2];
    int place[2];
};

Pair pairOf(dJointID joint, const std::vector<dBodyID> &bodies) {
    Pair pair{};
    for (int side = 0; side < 2; ++side) {
        pair.handle[side] = dJointGetBody(joint, side);
        pair.place[side] = placeOf(pair.handle[side], bodies);
    }
    return pair;
}

// Three rows that keep two points together.
void appendPointRows(const Pair &pair, const dReal *anchor1, const dReal *anchor2, double erp, double cfm, const RowContext &context,
                     std::vector<ConstraintRow> &rows) {
    const dReal *const anchors[2] = {anchor1, anchor2};
    for (int axis = 0; axis < 3; ++axis) {
        ConstraintRow row;
        for (int side = 0; side < 2; ++side) {
            row.body[side] = pair.place[side];
            if (row.body[side] == ConstraintRow::kNone) continue;
            const double sign = side == 0 ? 1 : -1;
            double arm[3];
            for (int i = 0; i < 3; ++i) arm[i] = anchors[side][i] - dBodyGetPosition(pair.handle[side])[i];
            // The velocity of the point along the axis is v + (omega x arm).
            row.jacobian[side][axis] = sign;
            row.jacobian[side][3 + (axis + 1) % 3] = sign * arm[(axis + 2) % 3];
            row.jacobian[side][3 + (axis + 2) % 3] = -sign * arm[(axis + 1) % 3];
        }
        row.c = erp / context.stepSize * (anchor2[axis] - anchor1[axis]);
        row.cfm = cfm;
        rows.push_back(row);
    }
}

ConstraintRow angularRow(const Pair &pair, const dReal *axis) {
    ConstraintRow row;
    for (int side = 0; side < 2; ++side) {
        row.body[side] = pair.place[side];
        if (row.body[side] == ConstraintRow::kNone) continue;
        for (int i = 0; i < 3; ++i) row.jacobian[side][3 + i] = side == 0 ? axis[i] : -axis[i];
    }
    return row;
}

double hingeParameter(dJointID joint, int parameter) { return dJointGetHingeParam(joint, parameter); }

// The row of a stop that is reached, or else of a motor.
void appendLimitRow(dJointID joint, const Pair &pair, const dReal *axis, const RowContext &context, std::vector<ConstraintRow> &rows) {
    const double low = hingeParameter(joint, dParamLoStop), high = hingeParameter(joint, dParamHiStop);
    const double angle = dJointGetHingeAngle(joint), force = hingeParameter(joint, dParamFMax);
    const bool isLow = low <= high && low >= -M_PI && angle <= low, isHigh = low <= high && high <= M_PI && !isLow && angle >= high;
    ConstraintRow row = angularRow(pair, axis);
    if (isLow || isHigh) {
        row.c = hingeParameter(joint, dParamStopERP) / context.stepSize * ((isLow ? low : high) - angle);
        row.cfm = hingeParameter(joint, dParamStopCFM);
        if (low != high) (isLow ? row.low : row.high) = 0;
    } else if (force > 0) {
        row.c = hingeParameter(joint, dParamVel);
        row.cfm = hingeParameter(joint, dParamCFM);
        row.low = -force;
        row.high = force;
    } else {
        return;
    }
    rows.push_back(row);
}

}  // namespace

namespace {

using Getter = dReal (*)(dJointID, int);
using Setter = void (*)(dJointID, int, dReal);

struct Access {
    Getter get;
    Setter set;
};

// Of joints with motors; null: the type has none that scenes drive.
Access accessTo(dJointID joint) {
    switch (dJointGetType(joint)) {
        case dJointTypeHinge: return {dJointGetHingeParam, dJointSetHingeParam};
        case dJointTypeUniversal: return {dJointGetUniversalParam, dJointSetUniversalParam};
        case dJointTypeHinge2: return {dJointGetHinge2Param, dJointSetHinge2Param};
        default: return {nullptr, nullptr};
    }
}

constexpr int kDriven[] = {dParamVel, dParamFMax, dParamVel2, dParamFMax2};

}  // namespace

JointState stateOf(dJointID joint) {
    JointState state{};
    const Access access = accessTo(joint);
    if (access.get != nullptr)
        for (int i = 0; i < JointState::kCount; ++i) state.driven[i] = access.get(joint, kDriven[i]);
    return state;
}

void restore(dJointID joint, const JointState &state) {
    const Access access = accessTo(joint);
    if (access.set == nullptr) return;
    const int count = dJointGetType(joint) == dJointTypeHinge ? JointState::kCount / 2 : JointState::kCount;
    for (int i = 0; i < count; ++i) access.set(joint, kDriven[i], state.driven[i]);
}

JointRows::JointRows(const std::vector<dJointID> &joints) {
    for (const dJointID joint : joints) {
        if (dJointGetType(joint) != dJointTypeHinge) continue;
        Axis &axis = m_hinges[joint];
        dJointGetHingeAxis(joint, axis.inSecond);
        if (const dBodyID second = dJointGetBody(joint, 1)) {
            const dVector3 inWorld = {axis.inSecond[0], axis.inSecond[1], axis.inSecond[2]};
            dBodyVectorFromWorld(second, inWorld[0], inWorld[1], inWorld[2], axis.inSecond);
        }
    }
}

void JointRows::append(dJointID joint, const RowContext &context, std::vector<ConstraintRow> &rows) const {
    if (dJointGetType(joint) == dJointTypeHinge) return appendHinge(joint, context, rows);
    if (dJointGetType(joint) != dJointTypeBall) return;
    dVector3 anchor1, anchor2;
    dJointGetBallAnchor(joint, anchor1);
    dJointGetBallAnchor2(joint, anchor2);
    appendPointRows(pairOf(joint, context.bodies), anchor1, anchor2, dJointGetBallParam(joint, dParamERP),
                    dJointGetBallParam(joint, dParamCFM), context, rows);
}

void JointRows::appendHinge(dJointID joint, const RowContext &context, std::vector<ConstraintRow> &rows) const {
    const Pair pair = pairOf(joint, context.bodies);
    const double erp = dWorldGetERP(context.world), cfm = dWorldGetCFM(context.world);
    dVector3 anchor1, anchor2, axis1, axis2, p, q, error;
    dJointGetHingeAnchor(joint, anchor1);
    dJointGetHingeAnchor2(joint, anchor2);
    appendPointRows(pair, anchor1, anchor2, erp, cfm, context, rows);
    dJointGetHingeAxis(joint, axis1);
    const dReal *const inSecond = m_hinges.at(joint).inSecond;
    if (pair.handle[1] != nullptr)
        dBodyVectorToWorld(pair.handle[1], inSecond[0], inSecond[1], inSecond[2], axis2);
    else
        std::copy_n(inSecond, 3, axis2);
    dPlaneSpace(axis1, p, q);
    dCalcVectorCross3(error, axis1, axis2);
    for (const dReal *direction : {p, q}) {
        ConstraintRow row = angularRow(pair, direction);
        row.c = erp / context.stepSize * dCalcVectorDot3(error, direction);
        row.cfm = cfm;
        rows.push_back(row);
    }
    appendLimitRow(joint, pair, axis1, context, rows);
}

// The first three rows are forces along the axes of the world; the axes of the others are orthonormal.
void JointRows::readForces(const dJointFeedback &feedback, ConstraintRow *first, ConstraintRow *end) {
    double rest[3] = {feedback.t1[0], feedback.t1[1], feedback.t1[2]};
    for (ConstraintRow *row = first; row != end; ++row) {
        row->force = 0;
        if (row - first < 3) {
            row->force = feedback.f1[row - first];
            for (int i = 0; i < 3; ++i) rest[i] -= row->jacobian[0][3 + i] * row->force;
        } else {
            for (int i = 0; i < 3; ++i) row->force += row->jacobian[0][3 + i] * rest[i];
        }
    }
}

}  // namespace quality
