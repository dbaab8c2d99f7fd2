#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/world_step/kernels/dxBodyColumns.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include <hwy/highway.h>

#include "dynamics/world_step/kernels/dxBodyColumns.h"

HWY_BEFORE_NAMESPACE();
namespace dxSolve {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<dReal, 8>;
using Numbers = hn::Vec<Tag>;

struct Matrix {
    Numbers element[9];
};

HWY_INLINE Matrix loadMatrix(const dReal (*columns)[kBodyColumns], unsigned lane) {
    Matrix matrix;
    for (unsigned k = 0; k < 9; ++k) matrix.element[k] = hn::Load(Tag(), columns[k] + lane);
    return matrix;
}

HWY_INLINE Numbers dot(Numbers a, Numbers b, Numbers c, Numbers x, Numbers y, Numbers z) {
    return hn::Add(hn::Add(hn::Mul(a, x), hn::Mul(b, y)), hn::Mul(c, z));
}

HWY_INLINE Numbers dotRow(const Matrix &matrix, unsigned row, const Numbers *vector) {
    const Numbers *const elements = matrix.element + 3 * row;
    return dot(elements[0], elements[1], elements[2], vector[0], vector[1], vector[2]);
}

// a b
HWY_INLINE Matrix multiply(const Matrix &a, const Matrix &b) {
    Matrix product;
    for (unsigned row = 0; row < 3; ++row)
        for (unsigned column = 0; column < 3; ++column) {
            const Numbers *const elements = a.element + 3 * row;
            product.element[3 * row + column] =
                dot(elements[0], elements[1], elements[2], b.element[column], b.element[3 + column], b.element[6 + column]);
        }
    return product;
}

// rotation tensor rotation'
HWY_INLINE Matrix rotateTensor(const Matrix &tensor, const Matrix &rotation) {
    Matrix half;
    for (unsigned row = 0; row < 3; ++row)
        for (unsigned column = 0; column < 3; ++column)
            half.element[3 * row + column] = dotRow(rotation, column, tensor.element + 3 * row);
    return multiply(rotation, half);
}

// a b - c d
HWY_INLINE Numbers subtractProducts(Numbers a, Numbers b, Numbers c, Numbers d) { return hn::Sub(hn::Mul(a, b), hn::Mul(c, d)); }

HWY_INLINE Numbers findDeterminant(const Matrix &matrix) {
    const Numbers *const m = matrix.element;
    const Numbers first = hn::Mul(m[0], subtractProducts(m[4], m[8], m[7], m[5]));
    const Numbers second = hn::Mul(m[1], subtractProducts(m[3], m[8], m[6], m[5]));
    return hn::Add(hn::Sub(first, second), hn::Mul(m[2], subtractProducts(m[3], m[7], m[6], m[4])));
}

HWY_INLINE Matrix invert(const Matrix &matrix, Numbers determinant) {
    const Numbers *const m = matrix.element;
    const Numbers reciprocal = hn::Div(hn::Set(Tag(), dReal(1)), determinant);
    return {{hn::Mul(subtractProducts(m[4], m[8], m[5], m[7]), reciprocal), hn::Mul(subtractProducts(m[7], m[2], m[1], m[8]), reciprocal),
             hn::Mul(subtractProducts(m[1], m[5], m[4], m[2]), reciprocal), hn::Mul(subtractProducts(m[5], m[6], m[3], m[8]), reciprocal),
             hn::Mul(subtractProducts(m[0], m[8], m[6], m[2]), reciprocal), hn::Mul(subtractProducts(m[3], m[2], m[0], m[5]), reciprocal),
             hn::Mul(subtractProducts(m[3], m[7], m[6], m[4]), reciprocal), hn::Mul(subtractProducts(m[6], m[1], m[0], m[7]), reciprocal),
             hn::Mul(subtractProducts(m[0], m[4], m[1], m[3]), reciprocal)}};
}

// The torque of dxAddGyroscopicTorque.
HWY_INLINE void findTorque(dxInertiaColumns &columns, unsigned lane, const Matrix &rotation, dReal stepSize) {
    const Tag d;
    const Matrix inertia = rotateTensor(loadMatrix(columns.tensor, lane), rotation);
    Numbers velocity[3], momentum[3];
    for (unsigned axis = 0; axis < 3; ++axis) velocity[axis] = hn::Load(d, columns.velocity[axis] + lane);
    for (unsigned axis = 0; axis < 3; ++axis) momentum[axis] = dotRow(inertia, axis, velocity);
    const Numbers h = hn::Set(d, stepSize), zero = hn::Zero(d);
    const auto addTurned = [&](Numbers element, unsigned k) HWY_ATTR { return hn::Add(hn::Mul(element, h), inertia.element[k]); };
    const Matrix system = {{addTurned(zero, 0), addTurned(momentum[2], 1), addTurned(hn::Neg(momentum[1]), 2),
                            addTurned(hn::Neg(momentum[2]), 3), addTurned(zero, 4), addTurned(momentum[0], 5),
                            addTurned(momentum[1], 6), addTurned(hn::Neg(momentum[0]), 7), addTurned(zero, 8)}};
    const Numbers determinant = findDeterminant(system);
    hn::Store(determinant, d, columns.determinant + lane);
    Matrix change = multiply(inertia, invert(system, determinant));
    for (unsigned k = 0; k < 9; k += 4) change.element[k] = hn::Sub(change.element[k], hn::Set(d, dReal(1)));
    const Numbers perSecond = hn::Set(d, dRecip(stepSize));
    for (unsigned axis = 0; axis < 3; ++axis) momentum[axis] = hn::Mul(momentum[axis], perSecond);
    for (unsigned axis = 0; axis < 3; ++axis) hn::Store(dotRow(change, axis, momentum), d, columns.torque[axis] + lane);
}

void findInertia(dxInertiaColumns &columns, unsigned count, dReal stepSize) {
    const Tag d;
    for (unsigned lane = 0; lane < count; lane += hn::Lanes(d)) {
        const Matrix rotation = loadMatrix(columns.rotation, lane);
        const Matrix inverse = rotateTensor(loadMatrix(columns.inverseTensor, lane), rotation);
        for (unsigned k = 0; k < 9; ++k) hn::Store(inverse.element[k], d, columns.inverse[k] + lane);
        findTorque(columns, lane, rotation, stepSize);
    }
}

// q + h q', q' being half of the velocity times q.
HWY_INLINE void turn(const Numbers *w, Numbers *q, dReal stepSize) {
    const Tag d;
    const Numbers half = hn::Set(d, dReal(0.5)), h = hn::Set(d, stepSize);
    const auto step = [&](Numbers number, Numbers sum) HWY_ATTR { return hn::Add(number, hn::Mul(h, hn::Mul(half, sum))); };
    const Numbers next[4] = {
        step(q[0], hn::Sub(hn::Sub(hn::Mul(hn::Neg(w[0]), q[1]), hn::Mul(w[1], q[2])), hn::Mul(w[2], q[3]))),
        step(q[1], hn::Sub(hn::Add(hn::Mul(w[0], q[0]), hn::Mul(w[1], q[3])), hn::Mul(w[2], q[2]))),
        step(q[2], hn::Add(hn::Add(hn::Mul(hn::Neg(w[0]), q[3]), hn::Mul(w[1], q[0])), hn::Mul(w[2], q[1]))),
        step(q[3], hn::Add(hn::Sub(hn::Mul(w[0], q[2]), hn::Mul(w[1], q[1])), hn::Mul(w[2], q[0])))};
    const Numbers square = hn::Add(hn::Add(hn::Add(hn::Mul(next[0], next[0]), hn::Mul(next[1], next[1])), hn::Mul(next[2], next[2])),
                                   hn::Mul(next[3], next[3]));
    const Numbers inverse = hn::Div(hn::Set(d, dReal(1)), hn::Sqrt(square));
    for (unsigned k = 0; k < 4; ++k) q[k] = hn::Mul(next[k], inverse);
}

// The rotation of a quaternion.
HWY_INLINE Matrix rotationOf(const Numbers *q) {
    const Tag d;
    const Numbers one = hn::Set(d, dReal(1)), two = hn::Set(d, dReal(2));
    Numbers square[4];
    for (unsigned k = 1; k < 4; ++k) square[k] = hn::Mul(hn::Mul(two, q[k]), q[k]);
    const auto diagonal = [&](unsigned i, unsigned k) HWY_ATTR { return hn::Sub(hn::Sub(one, square[i]), square[k]); };
    const auto sum = [&](unsigned i, unsigned k, unsigned real) HWY_ATTR {
        return hn::Mul(two, hn::Add(hn::Mul(q[i], q[k]), hn::Mul(q[0], q[real])));
    };
    const auto difference = [&](unsigned i, unsigned k, unsigned real) HWY_ATTR {
        return hn::Mul(two, hn::Sub(hn::Mul(q[i], q[k]), hn::Mul(q[0], q[real])));
    };
    return {{diagonal(2, 3), difference(1, 2, 3), sum(1, 3, 2), sum(1, 2, 3), diagonal(1, 3), difference(2, 3, 1),
             difference(1, 3, 2), sum(2, 3, 1), diagonal(1, 2)}};
}

void turnBodies(dxTurnColumns &columns, unsigned count, dReal stepSize) {
    const Tag d;
    for (unsigned lane = 0; lane < count; lane += hn::Lanes(d)) {
        Numbers velocity[3], orientation[4];
        for (unsigned k = 0; k < 3; ++k) velocity[k] = hn::Load(d, columns.velocity[k] + lane);
        for (unsigned k = 0; k < 4; ++k) orientation[k] = hn::Load(d, columns.orientation[k] + lane);
        turn(velocity, orientation, stepSize);
        for (unsigned k = 0; k < 4; ++k) hn::Store(orientation[k], d, columns.orientation[k] + lane);
        const Matrix rotation = rotationOf(orientation);
        for (unsigned k = 0; k < 9; ++k) hn::Store(rotation.element[k], d, columns.rotation[k] + lane);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace dxSolve
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxSolve {
HWY_EXPORT(findInertia);
HWY_EXPORT(turnBodies);
}  // namespace dxSolve

void dxFindInertia(dxInertiaColumns &columns, unsigned count, dReal stepSize) {
    HWY_DYNAMIC_DISPATCH(dxSolve::findInertia)(columns, count, stepSize);
}

void dxTurnBodies(dxTurnColumns &columns, unsigned count, dReal stepSize) {
    HWY_DYNAMIC_DISPATCH(dxSolve::turnBodies)(columns, count, stepSize);
}
#endif
