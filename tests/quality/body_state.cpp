#include "body_state.h"

#include <algorithm>

namespace quality {

BodyState stateOf(dBodyID body) {
    BodyState state{};
    std::copy_n(dBodyGetPosition(body), 3, state.position);
    std::copy_n(dBodyGetQuaternion(body), 4, state.rotation);
    std::copy_n(dBodyGetLinearVel(body), 3, state.linear);
    std::copy_n(dBodyGetAngularVel(body), 3, state.angular);
    std::copy_n(dBodyGetForce(body), 3, state.force);
    std::copy_n(dBodyGetTorque(body), 3, state.torque);
    state.isEnabled = dBodyIsEnabled(body);
    return state;
}

void restore(dBodyID body, const BodyState &state) {
    dBodySetPosition(body, state.position[0], state.position[1], state.position[2]);
    dBodySetQuaternion(body, state.rotation);
    dBodySetLinearVel(body, state.linear[0], state.linear[1], state.linear[2]);
    dBodySetAngularVel(body, state.angular[0], state.angular[1], state.angular[2]);
    dBodySetForce(body, state.force[0], state.force[1], state.force[2]);
    dBodySetTorque(body, state.torque[0], state.torque[1], state.torque[2]);
    if (state.isEnabled)
        dBodyEnable(body);
    else
        dBodyDisable(body);
}

void InverseInertia::apply(const double load[6], double change[6]) const {
    for (int i = 0; i < 3; ++i) {
        change[i] = mass * load[i];
        change[3 + i] = tensor[i][0] * load[3] + tensor[i][1] * load[4] + tensor[i][2] * load[5];
    }
}

namespace {

// Of a symmetric, positive definite matrix: adjugate over determinant.
void invert(const double m[3][3], double inverse[3][3]) {
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            inverse[j][i] = m[i1][j1] * m[i2][j2] - m[i1][j2] * m[i2][j1];
        }
    const double determinant = m[0][0] * inverse[0][0] + m[0][1] * inverse[1][0] + m[0][2] * inverse[2][0];
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) inverse[i][j] /= determinant;
}

}  // namespace

InverseInertia inverseInertiaOf(dBodyID body) {
    InverseInertia result;
    if (dBodyIsKinematic(body)) return result;
    dMass mass;
    dBodyGetMass(body, &mass);
    result.mass = 1 / mass.mass;
    double own[3][3], inverse[3][3];
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) own[i][j] = mass.I[4 * i + j];
    invert(own, inverse);
    const dReal *const r = dBodyGetRotation(body);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k)
                for (int l = 0; l < 3; ++l) result.tensor[i][j] += r[4 * i + k] * inverse[k][l] * r[4 * j + l];
    return result;
}

}  // namespace quality
