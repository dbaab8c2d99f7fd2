#include "dynamics/world_step/fast/dxDantzigTrial.h"

#include <ode/error.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "util.h"

#include "dynamics/step/islands/dxIslandStep.h"
#include "dynamics/world_step/exact/dxDantzigSolver.h"
#include "dynamics/world_step/fast/dxBodySpaceProblem.h"
#include "dynamics/world_step/fast/dxResidual.h"

namespace {

constexpr int kPair = dxJoint::GI2__RHS_CFM_MAX, kForce = dxJoint::GI2_CFM;

constexpr std::size_t kAlignment = alignof(dxBodyVector);

// The residual of a factorisation is rounding of such sums, some 1e-14 of the largest: less than an answer's by four digits.
constexpr double kMaxSmallSum = 1e4;

template <class Element>
std::size_t sizeOf(std::size_t count) {
    return dOVERALIGNED_SIZE(count * sizeof(Element), kAlignment);
}

template <class Element>
Element *copy(dxWorldProcessMemArena &arena, const Element *from, std::size_t count) {
    Element *const to = arena.AllocateArray<Element>(count);
    std::copy_n(from, count, to);
    return to;
}

// A limit of a friction row is where the force is, if it has one that could be at a limit.
double residualOfFriction(double x, double w, bool isFinite) {
    if (x == 0) return 0;
    if (!isFinite) return std::fabs(w);
    return std::max(0.0, x > 0 ? w : -w);
}

}  // namespace

bool dxHeldMessage::takeOver(dxReport kind, int number, const char *format, va_list arguments) {
    if (kind != dxReport::Message) {
        leave();
        dxUpstreamScope *const outer = current();
        return outer != nullptr && outer->takeOver(kind, number, format, arguments);
    }
    if (!m_isHeld) std::vsnprintf(m_text, sizeof m_text, format, arguments);
    m_number = number;
    m_isHeld = true;
    return true;
}

// Neither happens where a message may.
std::uint32_t dxHeldMessage::takeBlock(std::uint64_t) { std::abort(); }
bool dxHeldMessage::defersMoved() const { return false; }

void dxHeldMessage::deliver() {
    leave();
    if (m_isHeld) dMessage(m_number, "%s", m_text);
}

std::size_t dxDantzigTrial::memory(std::size_t bodies, std::size_t rows) {
    return 2 * sizeOf<dReal>(rows * kPair) + sizeOf<int>(rows) + 3 * sizeOf<double>(rows) + 2 * sizeOf<dxBodyVector>(bodies) +
           sizeOf<dxInverseMass>(bodies);
}

dxDantzigTrial::dxDantzigTrial(const dxIslandStep &step, const dxWorldStepProblem &problem, const dxHeldMessage &message)
    : m_step(step), m_problem(problem), m_unsolved(problem), m_state(step.arena->SaveState()) {
    keepRows();
    void *const state = step.arena->SaveState();
    dReal *const matrix = dxMakeMatrix(step, problem);
    findSizes(matrix);
    dxDantzigSolver::solve(step, problem, matrix);
    step.arena->RestoreState(state);
    m_isAnswer = !message.isHeld() && (areForcesSmall() || findIfAnswer());
    step.arena->RestoreState(state);
}

dxDantzigTrial::~dxDantzigTrial() { m_step.arena->RestoreState(m_state); }

// The algorithm writes to these arrays.
void dxDantzigTrial::keepRows() {
    const std::size_t rows = m_problem.rowCount;
    m_unsolved.pairsBX = copy(*m_step.arena, m_problem.pairsBX, rows * kPair);
    m_unsolved.pairsLoHi = copy(*m_step.arena, m_problem.pairsLoHi, rows * kPair);
    m_unsolved.normalOf = copy(*m_step.arena, m_problem.normalOf, rows);
    m_diagonal = m_step.arena->AllocateArray<double>(rows);
}

// Of the matrix and b, made.
void dxDantzigTrial::findSizes(const dReal *matrix) {
    const std::size_t rows = m_problem.rowCount, skip = dPAD(m_problem.rowCount);
    for (std::size_t row = 0; row < rows; ++row) {
        m_diagonal[row] = matrix[row * skip + row];
        m_largestB = std::max(m_largestB, std::fabs(double(m_problem.pairsBX[row * kPair + dxJoint::GI2_RHS])));
    }
}

// Of forces that are no numbers it is false.
bool dxDantzigTrial::areForcesSmall() const {
    const double most = kMaxSmallSum * m_largestB;
    bool areSmall = true;
    for (std::size_t row = 0; row < m_problem.rowCount; ++row)
        areSmall &= m_diagonal[row] * std::fabs(m_problem.pairsBX[row * kPair + kForce]) <= most;
    return areSmall;
}

bool dxDantzigTrial::findIfAnswer() const {
    dxWorldProcessMemArena &arena = *m_step.arena;
    const std::size_t rows = m_problem.rowCount;
    auto *const motions = arena.AllocateOveralignedArray<dxBodyVector>(m_problem.bodyCount, kAlignment);
    dxFindBodyMotions(m_problem, m_step.stepSize, motions);
    double *const forces = arena.AllocateArray<double>(rows);
    double softSum = 0;
    for (std::size_t row = 0; row < rows; ++row) {
        forces[row] = m_problem.pairsBX[row * kPair + kForce];
        const double c = m_unsolved.pairsBX[row * kPair + dxJoint::GI2_CFM], sum = m_diagonal[row] * std::fabs(forces[row]);
        if (sum > softSum && dxBodySpaceProblem::isSoft(c, m_diagonal[row])) softSum = sum;
    }
    const double residual = findResidual(motions, forces);
    return std::isfinite(residual) && dxIsAnswer(residual, m_largestB, softSum, m_problem, motions);
}

// Of the worst row.
double dxDantzigTrial::findResidual(const dxBodyVector *motions, const double *forces) const {
    dxWorldProcessMemArena &arena = *m_step.arena;
    const std::size_t rows = m_problem.rowCount;
    auto *const accelerations = arena.AllocateOveralignedArray<dxBodyVector>(m_problem.bodyCount, kAlignment);
    auto *const inverseMasses = arena.AllocateArray<dxInverseMass>(m_problem.bodyCount);
    double *const w = arena.AllocateArray<double>(rows);
    dxFindInverseMasses(m_problem, inverseMasses);
    dxFindRowResidual(m_unsolved, inverseMasses, motions, forces, accelerations, w);
    dxWorstResidual worst;
    for (std::size_t row = 0; row < rows; ++row) {
        const double low = m_unsolved.pairsLoHi[row * kPair + dxJoint::GI2_LO], high = m_unsolved.pairsLoHi[row * kPair + dxJoint::GI2_HI];
        worst.add(m_unsolved.normalOf[row] != -1 ? residualOfFriction(forces[row], w[row], high < dInfinity)
                                                 : dxKktResidual(dxSnapToLimit(forces[row], low, high), w[row], low, high),
                  w[row]);
    }
    return worst.get();
}
