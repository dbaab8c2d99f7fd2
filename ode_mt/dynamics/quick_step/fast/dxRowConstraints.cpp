#include "dynamics/quick_step/fast/dxRowConstraints.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <ode/odemath.h>

#include "joints/contact.h"

#include "core/dxCacheLine.h"
#include "dynamics/quick_step/fast/dxContactCache.h"
#include "dynamics/quick_step/fast/dxFastQuickStepState.h"
#include "dynamics/quick_step/sor/dxSorPlain.h"
#include "dynamics/quick_step/sor/dxSorSweep.h"

namespace {

using dxSorKernels::dot6;
using Row = dxConstraintRow;
using Manifold = dxConstraintPlan::Manifold;

constexpr int kJacobianOf[2] = {Row::kBody1, Row::kBody2};

// An infinite coefficient allows any force, as long as the row that bounds this one has a force.
dReal limited(dReal impulse, const Row &row, dReal bounding) {
    if (!row.hasFrictionIndex()) return std::max(row.jacobian[Row::kLow], std::min(row.jacobian[Row::kHigh], impulse));
    const dReal limit = bounding != 0 ? std::fabs(row.jacobian[Row::kHigh] * bounding) : 0;
    return std::max(-limit, std::min(limit, impulse));
}

// The velocity of a body that does not move becomes a part of the right-hand side, so that rows need not wait for one another because of it.
void leaveOutUnmoved(Row &row, const dxIslandBody *bodies, const dxSpatialMotion *velocities) {
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

const dxJointContact &contactOf(const dxIslandStep &step, unsigned joint) {
    return static_cast<const dxJointContact &>(*step.island.joints[joint]);
}

// From the centre of one of the bodies to a contact.
dReal offsetOf(const dxJointContact &contact, bool isOfA, int axis) {
    return contact.contact.geom.pos[axis] - contact.node[isOfA ? 0 : 1].body->posr.pos[axis];
}

dReal normalOf(const dxJointContact &contact, int axis) {
    const dReal normal = contact.contact.geom.normal[axis];
    return (contact.flags & dJOINT_REVERSE) != 0 ? -normal : normal;
}

}  // namespace

dxRowJoints::dxRowJoints(const dxIslandStep &step, const dxConstraintPlan &plan) : m_step(step) {
    const dxArenaArray<const dxConstraintPlan::RowJoint> rowJoints = plan.rowJoints();
    m_step.island.jointCount = static_cast<unsigned>(rowJoints.size());
    if (rowJoints.empty()) return;
    dxJoint **const joints = step.arena->AllocateArray<dxJoint *>(rowJoints.size());
    std::transform(rowJoints.begin(), rowJoints.end(), joints,
                   [&step](const dxConstraintPlan::RowJoint &row) { return step.island.joints[row.joint]; });
    m_step.island.joints = joints;
    m_reader.emplace(m_step);
    if (rowCount() == 0) return;
    m_rows = step.arena->AllocateOveralignedArray<dxConstraintRow>(rowCount(), kCacheLine);
    m_reader->read(m_rows);
}

void dxRowConstraints::reserve(const dxConstraintPlan &plan, dxStepArena &arena) {
    const std::size_t joints = plan.rowJoints().size(), rows = Row::kMaxOfJoint * joints;
    m_order.reserve(joints, rows, arena);
    m_firstRow = arena.take<unsigned>(joints + 1);
    m_energies = arena.take<double>(joints);
    m_directions = arena.take<Direction>(rows);
    m_diagonal = arena.take<dReal>(rows);
    m_last = arena.take<dReal>(rows);
}

// The rows' directions are noted first: rows will be scaled, and lose bodies that do not move.
void dxRowConstraints::begin(const dxRowJoints &joints, const dxConstraintPlan &plan) {
    m_plan = &plan;
    m_rows = joints.rows();
    m_rowCount = joints.rowCount();
    findRows(joints);
    m_order.make(plan, m_firstRow, m_rows);
    std::fill(m_energies.begin(), m_energies.end(), 0.0);
    plan.forRowManifolds([this](const Manifold &manifold) {
        const unsigned end = m_firstRow[manifold.firstRowJoint() + manifold.contactCount];
        for (unsigned i = m_firstRow[manifold.firstRowJoint()]; i < end; ++i)
            std::copy_n(m_rows[i].jacobian + Row::kBody1, 3, m_directions[i].axis);
    });
}

void dxRowConstraints::startWarm(const dxIslandStep &step) {
    m_plan->forRowManifolds([&](const Manifold &manifold) {
        step.fastQuickStep->cache().match(
            step, manifold,
            [&](unsigned k, bool isOfA, int axis) { return offsetOf(contactOf(step, manifold.firstJoint + k), isOfA, axis); },
            [&](unsigned k, int axis) { return normalOf(contactOf(step, manifold.firstJoint + k), axis); },
            [&](unsigned k, const dReal *impulse) { startContact(manifold.firstRowJoint() + k, impulse); });
    });
}

void dxRowConstraints::keep(const dxIslandStep &step) const {
    dxContactCache &cache = step.fastQuickStep->cache();
    const unsigned firstJoint = cache.firstJoint(step.island);
    const dReal perStep = dRecip(step.stepSize);
    m_plan->forRowManifolds([&](Manifold &manifold) {
        const unsigned firstContact = firstJoint + manifold.firstJoint;
        manifold.firstOwns = cache.keep(cache.numberOf(step.island, manifold.body[0]), cache.numberOf(step.island, manifold.body[1]),
                                        firstContact, manifold.contactCount);
        const dReal sign = manifold.firstOwns ? 1 : -1;
        for (unsigned k = 0; k < manifold.contactCount; ++k) {
            const dxJointContact &contact = contactOf(step, manifold.firstJoint + k);
            dVector3 impulse;
            findContactImpulse(manifold.firstRowJoint() + k, impulse);
            dxContactCache::Contact &kept = cache.contacts(firstContact)[k];
            for (int axis = 0; axis < 3; ++axis) {
                kept.r[axis] = static_cast<float>(offsetOf(contact, manifold.firstOwns, axis));
                kept.normal[axis] = static_cast<float>(sign * normalOf(contact, axis));
                kept.force[axis] = static_cast<float>(sign * perStep * impulse[axis]);
            }
        }
    });
}

double dxRowConstraints::prepareRow(Row &row, const dxIslandBody *bodies, const dxSpatialMotion *velocities, dReal stepSize,
                               dReal &diagonal) {
    row.jacobian[Row::kRhs] *= stepSize;
    if (!row.hasFrictionIndex()) {
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
    m_hasFriction |= row.hasFrictionIndex();
    const dReal allowed = row.hasFrictionIndex() ? 0 : std::max(row.jacobian[Row::kLow], std::min(row.jacobian[Row::kHigh], impulse));
    for (int side = 0; side < sides; ++side)
        for (int i = 0; i < Row::kBodyColumns; ++i) row.jacobian[kJacobianOf[side] + i] *= scale;
    row.jacobian[Row::kRhs] *= scale;
    row.jacobian[Row::kCfm] *= scale;
    return std::fabs(static_cast<double>(allowed * impulse * diagonal));
}

void dxRowConstraints::startContact(unsigned joint, const dReal *impulse) {
    for (unsigned i = m_firstRow[joint]; i < m_firstRow[joint + 1]; ++i)
        m_rows[i].lambda = dCalcVectorDot3(m_directions[i].axis, impulse);
}

void dxRowConstraints::findContactImpulse(unsigned joint, dReal *impulse) const {
    std::fill_n(impulse, 3, dReal(0));
    for (unsigned i = m_firstRow[joint]; i < m_firstRow[joint + 1]; ++i)
        for (int axis = 0; axis < 3; ++axis) impulse[axis] += m_directions[i].axis[axis] * m_rows[i].lambda;
}

double dxRowConstraints::prepare(const dxRowJoints &joints, const dxIslandBody *bodies, unsigned bodyCount, dxSpatialMotion *velocities,
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
            row.lambda = std::isfinite(impulse) ? limited(impulse, row, row.hasFrictionIndex() ? m_rows[row.boundingRow].lambda : 0) : 0;
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
void dxRowConstraints::findRows(const dxRowJoints &joints) {
    const dxArenaArray<const dxConstraintPlan::RowJoint> rowJoints = m_plan->rowJoints();
    m_firstRow[0] = 0;
    std::size_t next = 0;
    joints.forJoints([&](const dxJoint *joint, unsigned first, unsigned count) {
        while (m_plan->jointOf(rowJoints[next]) != joint) m_firstRow[++next] = first;
        m_firstRow[++next] = first + count;
    });
    while (next < rowJoints.size()) m_firstRow[++next] = joints.rowCount();
}

// Returns by how much the row's impulse raises the energy. Rows are scaled by factor / diagonal, so that the impulse itself moves the row by
// factor times the impulse, half of which counts.
double dxRowConstraints::applyRow(unsigned index, dxSpatialMotion *velocities) const {
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
double dxRowConstraints::forJoints(unsigned begin, unsigned end, const EnergyOf &energyOf) {
    double sum = 0;
    for (unsigned place = begin; place < end; ++place) {
        const unsigned joint = m_plan->rowJointsInOrder()[place];
        double energy = 0;
        for (unsigned row = m_firstRow[joint]; row < m_firstRow[joint + 1]; ++row) energy += energyOf(row);
        m_energies[joint] = energy;
        sum += energy;
    }
    return sum;
}

double dxRowConstraints::apply(unsigned begin, unsigned end, dxSpatialMotion *velocities) {
    return forJoints(begin, end, [&](unsigned row) {
        m_last[row] = m_rows[row].lambda;
        return applyRow(row, velocities);
    });
}

double dxRowConstraints::sweep(unsigned begin, unsigned end, dxSpatialMotion *velocities, unsigned sweep, bool isMeasured) {
    const dxArenaArray<const int> order = m_order.inSweep(begin, end, sweep);
    dxIslandProblem problem = {};
    problem.rowCount = static_cast<unsigned>(order.size());
    problem.rows = m_rows;
    problem.accelerations = velocities;
    dxSorSweep(problem, order.data(), m_rowCount >= dxIslandProblem::kLarge);
    if (!isMeasured) return 0;
    return forJoints(begin, end, [&](unsigned row) {
        const dReal now = m_rows[row].lambda, change = now - std::exchange(m_last[row], now);
        return static_cast<double>(change * change * m_diagonal[row]);
    });
}

void dxRowConstraints::startCold(unsigned joint) {
    for (unsigned row = m_firstRow[joint]; row < m_firstRow[joint + 1]; ++row) m_rows[row].lambda = m_last[row] = 0;
}

void dxRowConstraints::endOverRelaxation(Row &row) {
    const dReal scale = 1 / m_factor;
    for (const int column : kJacobianOf)
        for (int i = 0; i < Row::kBodyColumns; ++i) row.jacobian[column + i] *= scale;
    row.jacobian[Row::kRhs] *= scale;
    row.jacobian[Row::kCfm] *= scale;
}

void dxRowConstraints::endOverRelaxation(unsigned begin, unsigned end) {
    if (m_factor <= 1) return;
    for (const int index : m_order.of(begin, end))
        if (!m_isFrictionRelaxed || !m_rows[index].hasFrictionIndex()) endOverRelaxation(m_rows[index]);
}

void dxRowConstraints::endOverRelaxationOfFriction() {
    m_isFrictionRelaxed = true;
    for (const int index : m_order.all())
        if (m_rows[index].hasFrictionIndex()) endOverRelaxation(m_rows[index]);
}

void dxRowConstraints::finish(dReal stepSize) {
    const dReal perStep = 1 / stepSize;
    for (unsigned i = 0; i < m_rowCount; ++i) m_rows[i].lambda *= perStep;
}
