#include "dynamics/world_step/exact/dxDantzigRun.h"

#include <ode/matrix.h>
#include <ode/odemath.h>

#include <algorithm>

#include "dynamics/world_step/exact/dxFactorRemoval.h"
#include "dynamics/world_step/exact/dxDantzigArrays.h"
#include "dynamics/world_step/exact/dxLcpMatrix.h"
#include "dynamics/world_step/exact/dxUpstreamLcp.h"
#include "dynamics/world_step/kernels/dxFactorLDLT.h"
#include "dynamics/world_step/kernels/dxSymmetricProducts.h"
#include "dynamics/world_step/kernels/dxPair.h"
#include "dynamics/world_step/kernels/dxSolveL1.h"
#include "dynamics/world_step/kernels/dxTriangle.h"

namespace {

// Below this many rows vectors do not pay.
constexpr unsigned kWideFactorRows = 24;

// For up to this many rows of N lanes take longer than one row after the other.
constexpr unsigned kFewRows = 2;

// Below this many rows lanes are as fast.
constexpr unsigned kSparseProductRows = 256;

// One in kSparsePart of the rows is taken before products of the others are kept.
constexpr unsigned kSparsePart = 4;

std::size_t sparseMemory(unsigned n) { return n < kSparseProductRows ? 0 : dxSparseRows::memory(n); }

// The sum of `count` products in upstream's order (calculateLargeVectorDot of ode/src/fastdot_impl.h). The k-th is
// inPlace(k), without an access to the list of indexes, for the first of them, and product(k) for all.
template <class InPlace, class Product>
dReal addUp(unsigned countInPlace, InPlace inPlace, unsigned count, Product product) {
    dReal sum = 0;
    unsigned k = 0;
    for (; k + 4 <= countInPlace; k += 4) sum += inPlace(k) + inPlace(k + 1) + inPlace(k + 2) + inPlace(k + 3);
    for (; k + 4 <= count; k += 4) sum += product(k) + product(k + 1) + product(k + 2) + product(k + 3);
    for (; k < count; ++k) sum += product(k);
    return sum;
}

}  // namespace

std::size_t dxDantzigRun::memory(unsigned n) {
    return dxArrayBytes<unsigned>(n) + dxDantzigArrays::memory(n) + sparseMemory(n);
}

dxDantzigRun::dxDantzigRun(dxLargeIslandWorkers *islandWorkers, dxWorldProcessMemArena *given, dxWorldProcessMemArena *arena,
                           const dxDantzigProblem &problem, bool maySkipZeros)
    : m_islandWorkers(islandWorkers),
      m_problem(problem),
      m_n(problem.n),
      m_order(dxTakeArray<unsigned>(arena, m_n)),
      m_bilateral(dxFindLcpOrder(problem, m_order)),
      m_arrays(dxDantzigArrays::take(arena, m_n, m_bilateral)),
      m_source(problem.A, dPAD(m_n), m_order, m_n),
      m_A(m_source, m_n, m_bilateral, m_arrays.matrix),
      m_sets(m_n, m_bilateral, m_arrays.sets),
      m_skip(dPAD(m_n)),
      m_factor(dxTakeArray<dReal>(given, std::size_t(m_skip) * m_n)),
      m_L(m_arrays.factorRows),
      m_d(m_arrays.diagonal),
      m_begins(m_arrays.begins),
      m_skyline(maySkipZeros ? dxSkyline(m_begins) : dxSkyline()),
      m_forward(m_A, m_sets, m_L, m_skyline, m_n, m_bilateral, m_arrays.solutions, m_arrays.solutionWords),
      m_arena(arena),
      m_sparse(m_A, m_sets, m_n, m_bilateral) {
    for (unsigned i = 0; i < m_n; ++i) {
        m_arrays.b[i] = problem.pairsBX[std::size_t(m_order[i]) * PBX__MAX + PBX_B];
        m_arrays.x[i] = 0;
        const dReal *limits = problem.pairsLoHi + std::size_t(m_order[i]) * PLH__MAX;
        m_arrays.limits[i] = {limits[PLH_LO], limits[PLH_HI]};
        m_L[i] = m_factor + std::size_t(m_skip) * i;
    }
}

void dxDantzigRun::solve() {
    if (m_bilateral > 0) solveBilateralRows();
    bool isFriction = false;  // limits of friction rows are known
    for (unsigned i = m_bilateral; i < m_n && !m_hasFailed && !m_isUnfit; ++i) {
        if (!m_A.take(i, m_skyline.skipsZeros())) {
            m_isUnfit = true;
            return;
        }
        if (!isFriction && m_problem.normalOf && m_problem.normalOf[m_order[i]] >= 0) {
            setFrictionLimits(i);
            isFriction = true;
        }
        if (!driveToZero(i)) {
            while (pivot(i) && !m_isUnfit) {
            }
        }
    }
}

void dxDantzigRun::deliver() const {
    for (unsigned i = 0; i < m_n; ++i) m_problem.pairsBX[std::size_t(m_order[i]) * PBX__MAX + PBX_X] = m_arrays.x[i];
}

void dxDantzigRun::deliverLimits(dReal *pairsLoHi) const {
    for (unsigned i = 0; i < m_n; ++i) {
        dReal *const limits = pairsLoHi + std::size_t(m_order[i]) * PLH__MAX;
        limits[PLH_LO] = m_arrays.limits[i].low;
        limits[PLH_HI] = m_arrays.limits[i].high;
    }
}

// Bilateral rows are in C from the start.
void dxDantzigRun::solveBilateralRows() {
    for (unsigned i = 0; i < m_bilateral; ++i) m_source.copyRow(i, m_L[i]);
    if (m_skyline.skipsZeros()) {
        m_isUnfit = !dxAreRowsFinite(m_factor, 0, m_bilateral, m_skip);
        if (m_isUnfit) return;
        dxFindSkyline(m_factor, m_bilateral, m_skip, m_begins);
    }
    if (m_bilateral < kWideFactorRows) {
        dFactorLDLT(m_factor, m_d, static_cast<int>(m_bilateral), static_cast<int>(m_skip));
    } else {
        dxFactorLDLT(m_factor, m_d, m_bilateral, m_skip, m_skyline, m_arrays.temporary);
    }
    std::copy_n(m_arrays.b, m_bilateral, m_arrays.x);
    dxSolveL1Straight(m_factor, m_arrays.x, m_bilateral, m_skip, m_skyline);
    for (unsigned i = 0; i < m_bilateral; ++i) m_arrays.x[i] *= m_d[i];
    dxSolveL1Transposed(m_L, m_arrays.x, m_bilateral, m_skyline);
}

// Friction is limited by the forces found for the normals: 0 for 0, whatever the coefficient.
void dxDantzigRun::setFrictionLimits(unsigned first) {
    dReal *byProblemRow = m_arrays.temporary;
    for (unsigned i = 0; i < m_n; ++i) byProblemRow[m_order[i]] = m_arrays.x[i];
    for (unsigned i = first; i < m_n; ++i) {
        const dReal normal = byProblemRow[m_problem.normalOf[m_order[i]]];
        const dReal high = normal == 0 ? 0 : dFabs(m_arrays.limits[i].high * normal);
        m_arrays.limits[i] = {normal == 0 ? 0 : -high, high};
    }
}

// True if row i satisfies the conditions as it is.
bool dxDantzigRun::driveToZero(unsigned i) {
    const dReal *row = m_A.row(i);
    const unsigned *indexes = m_sets.indexes(), *ofN = indexes + m_sets.countC();
    const dReal *x = m_arrays.x;
    const auto inPlace = [&](unsigned k) { return row[k] * x[k]; };
    const dReal overC = addUp(m_sets.inPlace(), inPlace, m_sets.countC(),
                              [&](unsigned k) { return row[indexes[k]] * x[indexes[k]]; });
    const dReal overN = addUp(0, inPlace, m_sets.countN(), [&](unsigned k) { return row[ofN[k]] * x[ofN[k]]; });
    m_arrays.w[i] = overC + overN - m_arrays.b[i];

    if (m_arrays.limits[i].low == 0 && m_arrays.w[i] >= 0) {
        addToN(i, false);
    } else if (m_arrays.limits[i].high == 0 && m_arrays.w[i] <= 0) {
        addToN(i, true);
    } else if (m_arrays.w[i] == 0) {
        findFactorColumn(i);
        addToC(i);
    } else {
        return false;
    }
    return true;
}

// Returns whether row i needs another step.
bool dxDantzigRun::pivot(unsigned i) {
    const bool isUp = m_arrays.w[i] <= 0;
    findDirection(i, isUp);
    const MaximumStep step = findMaximumStep(i, isUp);
    if (step.length <= 0) {
        giveUp(i, step.length);
        return false;
    }
    apply(i, isUp, step.length);
    return finish(i, step);
}

void dxDantzigRun::findFactorColumn(unsigned index) {
    const unsigned count = m_sets.countC();
    if (count == 0) return;
    m_A.mirror();
    m_forward.solve(index, m_d, {m_arrays.solved, scaled(), m_arrays.temporary}, m_islandWorkers);
}

void dxDantzigRun::findDirection(unsigned i, bool isUp) {
    findFactorColumn(i);
    if (m_sets.countC() > 0) findDeltaX(isUp);
    findDeltaW(i, isUp);
}

// deltaX(C) = -+ A(C,C)^-1 A(C,i), of which findFactorColumn has put the first half into m_arrays.temporary.
void dxDantzigRun::findDeltaX(bool isUp) {
    const unsigned count = m_sets.countC();
    m_islandWorkers.solveTriangle(std::size_t(count) * count / 2, [&](dxTaskRunner *runner) {
        dxSolveL1Transposed(m_L, m_arrays.temporary, count, m_skyline, runner);
    });
    const unsigned *positions = m_sets.factorPositions(), inPlace = m_sets.inPlace();
    if (isUp) {
        dReal *const solved = m_arrays.temporary;
        unsigned j = 0;
        for (; j + 4 <= count; j += 4) {
            dxStorePair(-dxLoadPair(solved + j), solved + j);
            dxStorePair(-dxLoadPair(solved + j + 2), solved + j + 2);
        }
        for (; j < count; ++j) solved[j] = -solved[j];
    }
    std::copy_n(m_arrays.temporary, inPlace, m_arrays.deltaX);
    for (unsigned j = inPlace; j < count; ++j) m_arrays.deltaX[positions[j]] = m_arrays.temporary[j];
}

// deltaW(N) = A(N,C) deltaX(C) +- A(N,i), and the same for row i. Rows that may not move at all stay in N, whatever their
// w. Whether a row leaves its side is as good as random, so the rows that do are listed, without a branch.
void dxDantzigRun::findDeltaW(unsigned i, bool isUp) {
    const unsigned *ofN = m_sets.indexes() + m_sets.countC();
    const dReal *row = m_A.row(i);
    findProducts(i);
    unsigned leaving = 0;
    for (unsigned k = 0; k < m_sets.countN(); ++k) {
        const unsigned other = ofN[k];
        const dReal deltaW = isUp ? m_arrays.deltaW[other] + row[other] : m_arrays.deltaW[other] - row[other];
        m_arrays.deltaW[other] = deltaW;
        m_arrays.leaving[leaving] = m_sets.countC() + k;
        leaving += deltaW * m_arrays.side[other] < 0;
    }
    m_countLeaving = leaving;
    m_arrays.deltaW[i] = isUp ? m_arrays.deltaW[i] + row[i] : m_arrays.deltaW[i] - row[i];
}

// A(row,C) deltaX(C)
dReal dxDantzigRun::multiplyByDeltaX(unsigned index) const {
    const dReal *row = m_A.row(index), *deltaX = m_arrays.deltaX;
    const unsigned *columns = m_sets.indexes();
    return addUp(m_sets.inPlace(), [&](unsigned k) { return row[k] * deltaX[k]; }, m_sets.countC(),
                 [&](unsigned k) { return row[columns[k]] * deltaX[k]; });
}

// Not before a part of the rows has been taken: it needs all of them.
bool dxDantzigRun::isSparseDue(unsigned i) const {
    return m_skyline.skipsZeros() && m_n >= kSparseProductRows && !m_sparse.isTried() && i >= m_n / kSparsePart;
}

void dxDantzigRun::buildSparse() {
    while (m_A.end() < m_n) m_isUnfit |= !m_A.take(m_A.end(), true);
    m_A.mirror();
    m_sparse.build(m_arena);
}

// A(N,C) deltaX(C), and the same for row i
void dxDantzigRun::findProducts(unsigned i) {
    const unsigned countC = m_sets.countC(), *columns = m_sets.indexes(), *ofN = columns + countC;
    if (countC == 0) {
        for (unsigned k = 0; k < m_sets.countN(); ++k) m_arrays.deltaW[ofN[k]] = 0;
        m_arrays.deltaW[i] = 0;
        return;
    }
    if (m_sets.countN() <= kFewRows) {
        for (unsigned k = 0; k < m_sets.countN(); ++k) m_arrays.deltaW[ofN[k]] = multiplyByDeltaX(ofN[k]);
        m_arrays.deltaW[i] = multiplyByDeltaX(i);
        return;
    }
    if (isSparseDue(i)) buildSparse();
    if (m_sparse.isBuilt()) {
        m_sparse.multiply(m_arrays.deltaX, i + 1, m_arrays.halfBlockN, m_arrays.deltaW, m_islandWorkers);
        m_arrays.deltaW[i] = multiplyByDeltaX(i);
    } else {
        ++m_arrays.halfBlockN[dxLcpHalfBlock(i)];
        dxComputeLaneProducts({m_A.rows(), m_A.rowSkip(), columns, m_arrays.deltaX, countC, dxLcpBlock(m_bilateral),
                               dxLcpBlock(i) + 1, m_arrays.halfBlockN, m_arrays.deltaW});
        --m_arrays.halfBlockN[dxLcpHalfBlock(i)];
    }
}

// Returns the maximum step after which all conditions still hold.
dxDantzigRun::MaximumStep dxDantzigRun::findMaximumStep(unsigned i, bool isUp) const {
    const dReal w = m_arrays.w[i], deltaW = m_arrays.deltaW[i];
    const dReal endless = w != 0 ? dCopySign(dInfinity, -w) : dReal(0);
    MaximumStep step = {deltaW != 0 ? -w / deltaW : endless, Event::Solved, 0};
    limitByOwnBounds(i, isUp, step);
    limitByN(step);
    limitByC(step);
    return step;
}

void dxDantzigRun::limitByOwnBounds(unsigned i, bool isUp, MaximumStep &step) const {
    const Limits &limits = m_arrays.limits[i];
    if (isUp ? !(limits.high < dInfinity) : !(limits.low > -dInfinity)) return;
    const dReal length = isUp ? limits.high - m_arrays.x[i] : m_arrays.x[i] - limits.low;
    if (length < step.length) step = {length, isUp ? Event::AtHigh : Event::AtLow, 0};
}

void dxDantzigRun::limitByN(MaximumStep &step) const {
    for (unsigned k = 0; k < m_countLeaving; ++k) {
        const unsigned row = m_sets.indexAt(m_arrays.leaving[k]);
        const dReal length = -m_arrays.w[row] / m_arrays.deltaW[row];
        if (length < step.length) step = {length, Event::LeavesN, m_arrays.leaving[k]};
    }
}

void dxDantzigRun::limitByC(MaximumStep &step) const {
    const auto eventAt = [&](unsigned position) {
        return m_arrays.deltaX[position] < 0 ? Event::CReachesLow : Event::CReachesHigh;
    };
    const unsigned inPlace = m_sets.inPlace();
    if (m_bilateral < inPlace) {
        const unsigned first = dxFindFirstAtLimit(m_arrays.x, m_arrays.deltaX, m_arrays.limits, m_bilateral, inPlace, step.length);
        if (first < inPlace) step = {step.length, eventAt(first), first};
    }
    for (unsigned position = std::max(m_bilateral, inPlace); position < m_sets.countC(); ++position) {
        const unsigned row = m_sets.indexAt(position);
        const dReal deltaX = m_arrays.deltaX[position];
        if (deltaX == 0) continue;
        const dReal length = (m_arrays.limits[row].towards(deltaX < 0) - m_arrays.x[row]) / deltaX;  // endless if there is no limit
        if (length < step.length) step = {length, eventAt(position), position};
    }
}

void dxDantzigRun::apply(unsigned i, bool isUp, dReal length) {
    const unsigned countC = m_sets.countC(), end = countC + m_sets.countN(), inPlace = m_sets.inPlace();
    const dReal *deltaX = m_arrays.deltaX;
    dReal *const x = m_arrays.x;
    unsigned position = 0;
    for (const dxPair lengths = {length, length}; position + 4 <= inPlace; position += 4) {
        const dxPair first = dxLoadPair(x + position) + lengths * dxLoadPair(deltaX + position);
        const dxPair second = dxLoadPair(x + position + 2) + lengths * dxLoadPair(deltaX + position + 2);
        dxStorePair(first, x + position);
        dxStorePair(second, x + position + 2);
    }
    for (; position < countC; ++position)
        m_arrays.x[m_sets.indexAt(position)] += length * deltaX[position];
    m_arrays.x[i] = isUp ? m_arrays.x[i] + length : m_arrays.x[i] - length;
    for (; position < end; ++position) {
        const unsigned row = m_sets.indexAt(position);
        m_arrays.w[row] += length * m_arrays.deltaW[row];
    }
    m_arrays.w[i] += length * m_arrays.deltaW[i];
}

// True if row i is not at rest yet.
bool dxDantzigRun::finish(unsigned i, const MaximumStep &step) {
    switch (step.event) {
        case Event::Solved:
            m_arrays.w[i] = 0;
            addToC(i);
            return false;
        case Event::AtLow:
            m_arrays.x[i] = m_arrays.limits[i].low;
            addToN(i, false);
            return false;
        case Event::AtHigh:
            m_arrays.x[i] = m_arrays.limits[i].high;
            addToN(i, true);
            return false;
        case Event::LeavesN:
            m_arrays.w[m_sets.indexAt(step.position)] = 0;
            moveFromNToC(step.position);
            return true;
        case Event::CReachesLow:
            moveFromCToN(step.position, false);
            return true;
        case Event::CReachesHigh:
            moveFromCToN(step.position, true);
            return true;
    }
    return false;
}

// Upstream continues with its current values, and with 0 for the rows that it has not driven to zero.
void dxDantzigRun::giveUp(unsigned i, dReal length) {
    std::fill(m_arrays.x + i, m_arrays.x + m_n, dReal(0));
    m_hasFailed = true;
    m_failedLength = length;
}

// Upstream adds this sum up as a dot product here, but one by one in moveFromNToC.
void dxDantzigRun::addToC(unsigned i) {
    const unsigned count = m_sets.countC();
    appendFactorRow(i, count > 0 ? dxDot(scaled(), m_arrays.solved, count) : 0);
    m_sets.addNextToC();
    m_sparse.append(i);
}

void dxDantzigRun::addToN(unsigned i, bool isHigh) {
    m_arrays.side[i] = sideAt(i, isHigh);
    ++m_arrays.halfBlockN[dxLcpHalfBlock(i)];
    m_sets.addNextToN();
}

dReal dxDantzigRun::sideAt(unsigned row, bool isHigh) const {
    if (m_arrays.limits[row].low == 0 && m_arrays.limits[row].high == 0) return 0;
    return isHigh ? dReal(-1) : dReal(1);
}

void dxDantzigRun::moveFromNToC(unsigned position) {
    const unsigned row = m_sets.indexAt(position), count = m_sets.countC();
    findFactorColumn(row);
    const dReal *const scaled = this->scaled();
    dReal product = 0;
    for (unsigned j = 0; j < count; ++j) product += scaled[j] * m_arrays.solved[j];
    appendFactorRow(row, product);
    --m_arrays.halfBlockN[dxLcpHalfBlock(row)];
    m_sets.moveFromNToC(position);
    m_sparse.append(row);
}

void dxDantzigRun::moveFromCToN(unsigned position, bool isHigh) {
    const unsigned row = m_sets.indexAt(position), factorRow = m_sets.factorRowAt(position);
    m_arrays.x[row] = isHigh ? m_arrays.limits[row].high : m_arrays.limits[row].low;
    m_arrays.side[row] = sideAt(row, isHigh);
    removeFactorRow(factorRow);
    m_forward.forgetFrom(factorRow);
    ++m_arrays.halfBlockN[dxLcpHalfBlock(row)];
    m_sparse.remove(position);
    m_sets.moveFromCToN(position, factorRow);
}

// The row itself is there (scaled()). `product`: that of the new row of L with D and itself. A pivot of 0 is made a tiny
// one, as upstream does.
void dxDantzigRun::appendFactorRow(unsigned index, dReal product) {
    const unsigned count = m_sets.countC();
    dReal diagonal = m_A.diagonal(index);
    m_begins[count] = firstSolved(count);
    if (count == 0) {
        m_d[0] = dRecip(diagonal);
        return;
    }
    if (diagonal == product) diagonal = dNextAfter(diagonal, dInfinity);
    m_d[count] = dRecip(diagonal - product);
}

// The first that is not zero.
unsigned dxDantzigRun::firstSolved(unsigned count) const {
    unsigned first = 0;
    while (m_skyline.skipsZeros() && first < count && m_arrays.solved[first] == 0) ++first;
    return first;
}

// Rows that begin after the removed one have nothing to do with it, and are only moved; the others may get
// elements after it.
void dxDantzigRun::removeFactorRow(unsigned factorRow) {
    const unsigned count = m_sets.countC();
    const unsigned *const indexes = m_sets.factorIndexes();
    dxRemoveFactorRow({m_L, m_d, count, factorRow, m_A.row(indexes[factorRow]), indexes, m_skyline, m_arrays.temporary});
    for (unsigned row = factorRow + 1; m_skyline.skipsZeros() && row < count; ++row)
        m_begins[row - 1] = m_begins[row] > factorRow ? m_begins[row] - 1 : m_begins[row];
}
