#include "dynamics/quick_step/fast/dxOtherRows.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <ode/odemath.h>

#include "core/dxReserve.h"
#include "dynamics/quick_step/sor/dxSorPlain.h"
#include "dynamics/quick_step/sor/dxSorSweep.h"

namespace {

using dxSorKernels::dot6;
using Row = dxConstraintRow;

constexpr std::size_t kMaxRows = 6;  // of a joint

constexpr int kJacobianOf[2] = {Row::kBody1, Row::kBody2};

// An infinite coefficient allows any force, as long as the row that bounds this one has one.
dReal limited(dReal impulse, const Row &row, dReal bounding) {
    if (!row.isBounded()) return std::max(row.jacobian[Row::kLow], std::min(row.jacobian[Row::kHigh], impulse));
    const dReal limit = bounding != 0 ? std::fabs(row.jacobian[Row::kHigh] * bounding) : 0;
    return std::max(-limit, std::min(limit, impulse));
}

// A body that does not move only adds to what is wanted, so that rows need not wait for one another on its account.
void leaveOutUnmoved(Row &row, const dxIslandBody *bodies, const dxVelocity *velocities) {
    for (int side = 1; side >= 0; --side) {
        const int body = row.body[side];
        if (body == Row::kNone || bodies[body].invMass > 0) continue;
        row.jacobian[Row::kRhs] -= dot6(row.jacobian + kJacobianOf[side], velocities[body].columns);
        if (side == 0) {
            std::copy_n(row.jacobian + Row::kBody2, Row::kBodyColumns, row.jacobian + Row::kBody1);
            row.body[0] = row.body[1];
        }
        row.body[1] = Row::kNone;
    }
}

}  // namespace

double dxOtherRows::prepareRow(Row &row, const dxIslandBody *bodies, const dxVelocity *velocities, dReal stepSize,
                               dReal &diagonal) {
    row.jacobian[Row::kRhs] *= stepSize;
    if (!row.isBounded()) {
        row.jacobian[Row::kLow] *= stepSize;
        row.jacobian[Row::kHigh] *= stepSize;
    }
    leaveOutUnmoved(row, bodies, velocities);
    const int sides = row.hasSecondBody() ? 2 : 1;
    dReal velocity = 0;
    diagonal = row.jacobian[Row::kCfm];
    for (int side = 0; side < sides; ++side) {
        const dReal *const jacobian = row.jacobian + kJacobianOf[side];
        dReal *const impulse = side == 0 ? row.impulseOn1 : row.impulseOn2;
        bodies[row.body[side]].respond(jacobian, impulse);
        velocity += dot6(jacobian, velocities[row.body[side]].columns);
        diagonal += dot6(impulse, jacobian);
    }
    const dReal inverse = diagonal > 0 ? 1 / diagonal : 0, scale = m_factor * inverse;
    const dReal impulse = (row.jacobian[Row::kRhs] - velocity) * inverse;
    m_order.mix(static_cast<double>(impulse));
    m_hasFriction |= row.isBounded();
    const dReal allowed = row.isBounded() ? 0 : std::max(row.jacobian[Row::kLow], std::min(row.jacobian[Row::kHigh], impulse));
    for (int side = 0; side < sides; ++side)
        for (int i = 0; i < Row::kBodyColumns; ++i) row.jacobian[kJacobianOf[side] + i] *= scale;
    row.jacobian[Row::kRhs] *= scale;
    row.jacobian[Row::kCfm] *= scale;
    return std::fabs(static_cast<double>(allowed * impulse * diagonal));
}

void dxOtherRows::reserve(const dxConstraintPlan &plan) {
    const std::size_t joints = plan.otherJoints().size(), rows = kMaxRows * joints;
    m_order.reserve(joints, rows);
    m_firstRow.reserve(joints + 1);
    m_energies.reserve(joints);
    m_directions.reserve(rows);
    m_diagonal.reserve(rows);
    m_last.reserve(rows);
}

void dxOtherRows::reserveAs(const dxOtherRows &other) {
    m_order.reserveAs(other.m_order);
    m_firstRow.reserve(other.m_firstRow.capacity());
    m_energies.reserve(other.m_energies.capacity());
    m_directions.reserve(other.m_directions.capacity());
    m_diagonal.reserve(other.m_diagonal.capacity());
    m_last.reserve(other.m_last.capacity());
}

void dxOtherRows::begin(const dxOtherJoints &joints, const dxConstraintPlan &plan) {
    m_plan = &plan;
    m_rows = joints.rows();
    findRows(joints);
    m_order.make(plan, m_firstRow, m_rows);
    m_directions.resize(joints.rowCount());
    m_diagonal.resize(joints.rowCount());
    m_last.resize(joints.rowCount());
    dxFill(m_energies, plan.otherJoints().size(), 0);
    for (const dxConstraintPlan::Manifold &manifold : plan.rowManifolds())
        noteDirections(m_firstRow[manifold.firstOther()], m_firstRow[manifold.firstOther() + manifold.contactCount]);
}

// Rows will be scaled, and lose bodies that do not move.
void dxOtherRows::noteDirections(unsigned begin, unsigned end) {
    for (unsigned i = begin; i < end; ++i) std::copy_n(m_rows[i].jacobian + Row::kBody1, 3, m_directions[i].axis);
}

void dxOtherRows::startContact(unsigned joint, const dReal *impulse) {
    for (unsigned i = m_firstRow[joint]; i < m_firstRow[joint + 1]; ++i)
        m_rows[i].lambda = dCalcVectorDot3(m_directions[i].axis, impulse);
}

void dxOtherRows::findContactImpulse(unsigned joint, dReal *impulse) const {
    std::fill_n(impulse, 3, dReal(0));
    for (unsigned i = m_firstRow[joint]; i < m_firstRow[joint + 1]; ++i)
        for (int axis = 0; axis < 3; ++axis) impulse[axis] += m_directions[i].axis[axis] * m_rows[i].lambda;
}

double dxOtherRows::prepare(const dxOtherJoints &joints, const dxIslandBody *bodies, unsigned bodyCount, dxVelocity *velocities,
                            dReal stepSize, dReal factor) {
    m_factor = factor;
    m_isFrictionRelaxed = m_hasFriction = false;
    double energy = 0;
    std::size_t index = 0;
    joints.forJoints([&](const dxJoint *, unsigned first, unsigned count) {
        while (m_firstRow[index + 1] <= first) ++index;
        for (unsigned i = 0; i < count; ++i) {
            Row &row = m_rows[first + i];
            m_energies[index] += prepareRow(row, bodies, velocities, stepSize, m_diagonal[first + i]);
            const dReal impulse = row.lambda;
            row.lambda = std::isfinite(impulse) ? limited(impulse, row, row.isBounded() ? m_rows[row.boundingRow].lambda : 0) : 0;
        }
        energy += m_energies[index];
    });
    dxIslandProblem problem = {};
    problem.bodyCount = bodyCount;
    problem.rows = m_rows;
    problem.accelerations = velocities;
    m_order.schedule(problem);
    return energy;
}

// Joints without rows have a place in the plan, too.
void dxOtherRows::findRows(const dxOtherJoints &joints) {
    const std::vector<dxConstraintPlan::OtherJoint> &others = m_plan->otherJoints();
    dxFill(m_firstRow, others.size() + 1, 0);
    std::size_t next = 0;
    joints.forJoints([&](const dxJoint *joint, unsigned first, unsigned count) {
        while (m_plan->jointOf(others[next]) != joint) m_firstRow[++next] = first;
        m_firstRow[++next] = first + count;
    });
    while (next < others.size()) m_firstRow[++next] = joints.rowCount();
}

// Returns by how much the row's impulse raises the energy. Rows are scaled by factor / diagonal, so that the impulse itself moves the row by
// factor times the impulse, half of which counts.
double dxOtherRows::push(unsigned index, dxVelocity *velocities) const {
    const Row &row = m_rows[index];
    if (row.lambda == 0) return 0;
    dReal motion = -row.jacobian[Row::kRhs];
    for (int side = 0; side < 2; ++side) {
        if (row.body[side] == Row::kNone) continue;
        const dReal *const impulse = side == 0 ? row.impulseOn1 : row.impulseOn2;
        dReal *const velocity = velocities[row.body[side]].columns;
        motion += dot6(row.jacobian + kJacobianOf[side], velocity);
        for (int k = 0; k < Row::kBodyColumns; ++k) velocity[k] += impulse[k] * row.lambda;
    }
    return m_factor != 0 ? static_cast<double>(row.lambda * (motion / m_factor + row.lambda / 2) * m_diagonal[index]) : 0;
}

// energyOf(row)
template <class EnergyOf>
double dxOtherRows::forJoints(unsigned begin, unsigned end, const EnergyOf &energyOf) {
    double sum = 0;
    for (unsigned place = begin; place < end; ++place) {
        const unsigned joint = m_plan->othersInOrder()[place];
        double energy = 0;
        for (unsigned row = m_firstRow[joint]; row < m_firstRow[joint + 1]; ++row) energy += energyOf(row);
        m_energies[joint] = energy;
        sum += energy;
    }
    return sum;
}

double dxOtherRows::apply(unsigned begin, unsigned end, dxVelocity *velocities) {
    return forJoints(begin, end, [&](unsigned row) {
        m_last[row] = m_rows[row].lambda;
        return push(row, velocities);
    });
}

double dxOtherRows::sweep(unsigned begin, unsigned end, dxVelocity *velocities, unsigned sweep, bool isMeasured) {
    const dxRowOrder::Rows order = m_order.inSweep(begin, end, sweep);
    dxIslandProblem problem = {};
    problem.rowCount = order.count();
    problem.rows = m_rows;
    problem.accelerations = velocities;
    dxSorSweep(problem, order.first);
    if (!isMeasured) return 0;
    return forJoints(begin, end, [&](unsigned row) {
        const dReal now = m_rows[row].lambda, change = now - std::exchange(m_last[row], now);
        return static_cast<double>(change * change * m_diagonal[row]);
    });
}

void dxOtherRows::startCold(unsigned joint) {
    for (unsigned row = m_firstRow[joint]; row < m_firstRow[joint + 1]; ++row) m_rows[row].lambda = m_last[row] = 0;
}

void dxOtherRows::relaxRow(Row &row) {
    const dReal scale = 1 / m_factor;
    for (const int column : kJacobianOf)
        for (int i = 0; i < Row::kBodyColumns; ++i) row.jacobian[column + i] *= scale;
    row.jacobian[Row::kRhs] *= scale;
    row.jacobian[Row::kCfm] *= scale;
}

void dxOtherRows::relax(unsigned begin, unsigned end) {
    if (m_factor <= 1) return;
    for (const int index : m_order.of(begin, end))
        if (!m_isFrictionRelaxed || !m_rows[index].isBounded()) relaxRow(m_rows[index]);
}

void dxOtherRows::relaxFriction() {
    m_isFrictionRelaxed = true;
    for (const int index : m_order.all())
        if (m_rows[index].isBounded()) relaxRow(m_rows[index]);
}

void dxOtherRows::finish(dReal stepSize) {
    const dReal perStep = 1 / stepSize;
    for (std::size_t i = 0; i < m_diagonal.size(); ++i) m_rows[i].lambda *= perStep;
}
