#include "dynamics/world_step/fast/dxBodySpaceProblem.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "dynamics/world_step/dxWorldStepProblem.h"
#include "dynamics/world_step/fast/dxResidual.h"

namespace {

constexpr unsigned kNoBody = dxManifold::kNoBody;
constexpr int kPair = dxJoint::GI2__RHS_CFM_MAX;

bool isFinite(const dxBodyVector &vector) {
    double sum = 0;
    for (const double lane : vector.lane) sum += lane * 0;
    return sum == 0;
}

// Writes the inverse of a symmetric 3 x 3 matrix, whose rows are `stride` elements apart. Returns false if it is not positive definite.
bool invert(const dReal *matrix, double (&inverse)[3][3]) {
    const double a = matrix[0], b = matrix[4], c = matrix[8], d = matrix[5], e = matrix[9], f = matrix[10];
    const double cofactorA = d * f - e * e, cofactorB = c * e - b * f, cofactorC = b * e - c * d;
    const double determinant = a * cofactorA + b * cofactorB + c * cofactorC;
    const double scale = 1 / determinant;
    if (!(a > 0 && a * d - b * b > 0 && determinant > 0 && std::isfinite(scale))) return false;
    inverse[0][0] = cofactorA * scale;
    inverse[0][1] = inverse[1][0] = cofactorB * scale;
    inverse[0][2] = inverse[2][0] = cofactorC * scale;
    inverse[1][1] = (a * f - c * c) * scale;
    inverse[1][2] = inverse[2][1] = (b * c - a * e) * scale;
    inverse[2][2] = (a * d - b * b) * scale;
    return true;
}

const dxBody *bodyOf(const dxWorldStepProblem &rows, unsigned joint, unsigned side) {
    return rows.joints[joint].joint->node[side].body;
}

}  // namespace

bool dxBodySpaceRows::gather(const dxWorldStepProblem &rows, double stepSize) {
    if (!numberBodies(rows)) return false;
    orderBodies(rows);
    if (!fillMasses(rows)) return false;
    m_motions.resize(rows.bodyCount);
    dxFindBodyMotions(rows, stepSize, m_motions.data());
    pairJoints(rows);
    if (!fillRows(rows)) return false;
    findDiagonal();
    return true;
}

// Bodies of infinite mass have no number.
bool dxBodySpaceRows::numberBodies(const dxWorldStepProblem &rows) {
    m_numberOf.assign(rows.bodyCount, kNoBody);
    m_tagOf.clear();
    for (unsigned i = 0; i < rows.bodyCount; ++i) {
        const double inverseMass = rows.bodies[i]->invMass;
        if (inverseMass == 0) continue;
        if (!(inverseMass > 0) || !std::isfinite(1 / inverseMass)) return false;
        m_numberOf[i] = static_cast<unsigned>(m_tagOf.size());
        m_tagOf.push_back(i);
    }
    return true;
}

void dxBodySpaceRows::orderBodies(const dxWorldStepProblem &rows) {
    m_edges.clear();
    for (unsigned i = 0; i < rows.jointCount; ++i) {
        const dxBody *const second = bodyOf(rows, i, dJCB_SECOND_BODY);
        if (second == nullptr) continue;
        const unsigned a = m_numberOf[bodyOf(rows, i, dJCB_FIRST_BODY)->tag], b = m_numberOf[second->tag];
        if (a != kNoBody && b != kNoBody) m_edges.emplace_back(a, b);
    }
    m_order.find(static_cast<unsigned>(m_tagOf.size()), m_edges);
}

bool dxBodySpaceRows::fillMasses(const dxWorldStepProblem &rows) {
    m_problem.bodyCount = static_cast<unsigned>(m_tagOf.size());
    m_problem.mass.assign(m_problem.bodyCount, dxBodyBlock{});
    m_problem.inverseMass.assign(m_problem.bodyCount, dxBodyBlock{});
    for (unsigned i = 0; i < m_problem.bodyCount; ++i) {
        const double inverseMass = rows.bodies[m_tagOf[i]]->invMass;
        const dReal *const tensor = rows.inverseInertia[m_tagOf[i]].tensor;
        double inertia[3][3];
        if (!invert(tensor, inertia)) return false;
        dxBodyBlock &mass = m_problem.mass[m_order.placeOf(i)], &inverse = m_problem.inverseMass[m_order.placeOf(i)];
        for (unsigned axis = 0; axis < 3; ++axis) {
            mass.column[axis].lane[axis] = 1 / inverseMass;
            inverse.column[axis].lane[axis] = inverseMass;
            for (unsigned other = 0; other < 3; ++other) {
                mass.column[3 + axis].lane[3 + other] = inertia[other][axis];
                inverse.column[3 + axis].lane[3 + other] = tensor[4 * other + axis];
            }
        }
    }
    return true;
}

unsigned dxBodySpaceRows::placeOf(const dxWorldStepProblem &rows, unsigned joint, unsigned side) const {
    const dxBody *const body = bodyOf(rows, joint, side);
    const unsigned number = body != nullptr ? m_numberOf[body->tag] : kNoBody;
    return number != kNoBody ? m_order.placeOf(number) : kNoBody;
}

// Joints of the same bodies side by side, those of one pair in the order of the joints. kNoBody is the largest number, so that a
// pair of one body has it first.
void dxBodySpaceRows::pairJoints(const dxWorldStepProblem &rows) {
    m_pairs.clear();
    for (unsigned i = 0; i < rows.jointCount; ++i) {
        const unsigned a = placeOf(rows, i, dJCB_FIRST_BODY), b = placeOf(rows, i, dJCB_SECOND_BODY);
        m_pairs.push_back({std::min(a, b), std::max(a, b), i, b < a});
    }
    std::sort(m_pairs.begin(), m_pairs.end(), [](const Pair &a, const Pair &b) {
        return std::tie(a.first, a.second, a.joint) < std::tie(b.first, b.second, b.joint);
    });
}

bool dxBodySpaceRows::fillRows(const dxWorldStepProblem &rows) {
    dxBodySpaceProblem &problem = m_problem;
    problem.rowCount = rows.rowCount;
    problem.jacobian.resize(2 * std::size_t(rows.rowCount));
    for (std::vector<double> *array : {&problem.b, &problem.c, &problem.lo, &problem.hi, &problem.diagonal})
        array->resize(rows.rowCount);
    problem.normalOf.resize(rows.rowCount);
    m_sourceOf.resize(rows.rowCount);
    m_rowOf.resize(rows.rowCount);
    problem.manifolds.clear();
    unsigned row = 0;
    for (const Pair &pair : m_pairs) {
        if (problem.manifolds.empty() || problem.manifolds.back().body[0] != pair.first ||
            problem.manifolds.back().body[1] != pair.second) {
            const unsigned block = pair.second != kNoBody ? m_order.findBlock(pair.second, pair.first) : 0;
            problem.manifolds.push_back({row, row, {pair.first, pair.second}, block});
        }
        const dxWorldStepJoint &joint = rows.joints[pair.joint];
        for (unsigned i = 0; i < joint.rows; ++i, ++row)
            if (!fillRow(rows, pair, joint.firstRow + i, row)) return false;
        problem.manifolds.back().endRow = row;
    }
    for (int &normal : problem.normalOf)
        if (normal != dxBodySpaceProblem::kNoNormal) normal = static_cast<int>(m_rowOf[normal]);
    return true;
}

// b = c/h - J (v/h + inv(M) f), of all bodies, also of those that no force moves.
bool dxBodySpaceRows::fillRow(const dxWorldStepProblem &rows, const Pair &pair, unsigned source, unsigned row) {
    const dxWorldStepJoint &joint = rows.joints[pair.joint];
    double b = rows.pairsBX[std::size_t(source) * kPair + dxJoint::GI2_RHS];
    for (unsigned side = 0; side < 2; ++side) {
        const dReal *const elements = rows.rowsOf(joint, side) + std::size_t(source - joint.firstRow) * dxWorldStepProblem::kElements;
        const dxBody *const body = joint.joint->node[side].body;
        const unsigned target = side ^ unsigned(pair.isSwapped);
        dxBodyVector &here = m_problem.jacobian[2 * std::size_t(row) + target];
        here = {};
        if (body == nullptr) continue;
        const dxBodyVector &motion = m_motions[body->tag];
        double sum = 0;
        for (unsigned k = 0; k < kBodyAxes; ++k) sum += elements[k] * motion.lane[k];
        b -= sum;
        if (m_numberOf[body->tag] == kNoBody) continue;
        for (unsigned k = 0; k < kBodyAxes; ++k) here.lane[k] = elements[k];
        if (!isFinite(here)) return false;
    }
    const double c = rows.pairsBX[std::size_t(source) * kPair + dxJoint::GI2_CFM];
    const double lo = rows.pairsLoHi[std::size_t(source) * kPair + dxJoint::GI2_LO];
    const double hi = rows.pairsLoHi[std::size_t(source) * kPair + dxJoint::GI2_HI];
    m_problem.b[row] = b;
    m_problem.c[row] = c;
    m_problem.lo[row] = lo;
    m_problem.hi[row] = hi;
    m_problem.normalOf[row] = rows.normalOf[source];
    m_sourceOf[row] = source;
    m_rowOf[source] = row;
    // Limits that upstream's solver asserts.
    return std::isfinite(b) && c >= 0 && std::isfinite(c) && lo <= 0 && hi >= 0;
}

void dxBodySpaceRows::findDiagonal() {
    for (const dxManifold &manifold : m_problem.manifolds)
        for (unsigned row = manifold.firstRow; row < manifold.endRow; ++row) {
            double sum = 0;
            for (unsigned side = 0; side < 2; ++side) {
                if (manifold.body[side] == kNoBody) continue;
                const double *const elements = m_problem.jacobian[2 * std::size_t(row) + side].lane;
                const dxBodyBlock &inverse = m_problem.inverseMass[manifold.body[side]];
                for (unsigned k = 0; k < kBodyAxes; ++k)
                    for (unsigned i = 0; i < kBodyAxes; ++i) sum += elements[i] * inverse.column[k].lane[i] * elements[k];
            }
            m_problem.diagonal[row] = sum;
        }
}

void dxBodySpaceRows::writeForces(const std::vector<double> &x, const dxWorldStepProblem &rows) const {
    for (unsigned row = 0; row < m_problem.rowCount; ++row)
        rows.pairsBX[std::size_t(m_sourceOf[row]) * kPair + dxJoint::GI2_CFM] = static_cast<dReal>(x[row]);
}

void dxBodySpaceRows::readForces(const dxWorldStepProblem &rows, std::vector<double> &x) const {
    x.resize(m_problem.rowCount);
    for (unsigned row = 0; row < m_problem.rowCount; ++row)
        x[row] = rows.pairsBX[std::size_t(m_sourceOf[row]) * kPair + dxJoint::GI2_CFM];
}
