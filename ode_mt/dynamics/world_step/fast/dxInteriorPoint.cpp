#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/world_step/fast/dxInteriorPoint.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include "dynamics/world_step/fast/dxBodyLanes-inl.h"
#include "dynamics/world_step/fast/dxInteriorPoint.h"
#include "dynamics/world_step/fast/dxResidual.h"

#include <algorithm>
#include <cmath>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace dxFastStepKernels {
namespace HWY_NAMESPACE {

using Rows = dxInteriorRows;
using Step = dxInteriorLoops::Step;
using V = hn::Vec<BodyTag>;

// Vectors that are kBodyLanes together.
constexpr unsigned kVectors = kBodyLanes / hn::MaxLanes(BodyTag());

// One sum, or one maximum, a lane.
class LaneSums {
public:
    LaneSums() {
        for (V &sum : m_sums) sum = hn::Zero(BodyTag());
    }
    void add(unsigned vector, V value) { m_sums[vector] = hn::Add(m_sums[vector], value); }

    // What is no number is ignored.
    void raise(unsigned vector, V value) { m_sums[vector] = hn::IfThenElse(hn::Gt(value, m_sums[vector]), value, m_sums[vector]); }

    double sum() const {
        alignas(kCacheLine) double lanes[kBodyLanes];
        store(lanes);
        return addUp(lanes);
    }
    double largest() const {
        alignas(kCacheLine) double lanes[kBodyLanes];
        store(lanes);
        double value = lanes[0];
        for (const double lane : lanes) value = lane > value ? lane : value;
        return value;
    }

private:
    void store(double *lanes) const {
        for (unsigned i = 0; i < kVectors; ++i) hn::Store(m_sums[i], BodyTag(), lanes + i * hn::Lanes(BodyTag()));
    }

    V m_sums[kVectors];
};

// Calls work(row, vector) for vectors of rows.
template <class Work>
HWY_INLINE void forVectors(unsigned begin, unsigned end, const Work &work) {
    const unsigned lanes = static_cast<unsigned>(hn::Lanes(BodyTag()));
    for (unsigned row = begin; row < end; row += kBodyLanes)
        for (unsigned vector = 0; vector < kVectors; ++vector) work(row + vector * lanes, vector);
}

HWY_INLINE V load(const std::vector<double> &array, unsigned row) { return hn::LoadU(BodyTag(), array.data() + row); }
HWY_INLINE void store(V value, std::vector<double> &array, unsigned row) { hn::StoreU(value, BodyTag(), array.data() + row); }

void prepare(Rows &rows, unsigned begin, unsigned end, const double *change, double *weight, double *scaled) {
    const BodyTag d;
    forVectors(begin, end, [&](unsigned i, unsigned) HWY_ATTR {
        const auto s = hn::Sub(hn::Sub(load(rows.b, i), hn::LoadU(d, change + i)), hn::Mul(load(rows.c, i), load(rows.x, i)));
        const auto byLow = hn::Div(load(rows.dualLow, i), load(rows.slackLow, i));
        const auto byHigh = hn::Div(load(rows.dualHigh, i), load(rows.slackHigh, i));
        const auto inverse = hn::Div(hn::Set(d, 1.0), hn::Add(hn::Add(load(rows.softness, i), byLow), byHigh));
        const auto w = hn::IfThenElseZero(hn::Ne(load(rows.low, i), load(rows.high, i)), inverse);
        store(s, rows.s, i);
        hn::StoreU(w, d, weight + i);
        hn::StoreU(hn::Mul(s, w), d, scaled + i);
    });
}

Step predict(Rows &rows, unsigned begin, unsigned end, const double *change, const double *weight) {
    const BodyTag d;
    LaneSums loss, energy;
    forVectors(begin, end, [&](unsigned i, unsigned vector) HWY_ATTR {
        const auto dx = hn::Mul(hn::Sub(load(rows.s, i), hn::LoadU(d, change + i)), hn::LoadU(d, weight + i));
        const auto dualLow = load(rows.dualLow, i), dualHigh = load(rows.dualHigh, i), zero = hn::Zero(d), one = hn::Set(d, 1.0);
        const auto partLow = hn::Div(dx, load(rows.slackLow, i)), partHigh = hn::Div(dx, load(rows.slackHigh, i));
        const auto dDualLow = hn::Sub(hn::Neg(dualLow), hn::Mul(dualLow, partLow));
        const auto dDualHigh = hn::Sub(hn::Mul(dualHigh, partHigh), dualHigh);
        store(dx, rows.dx, i);
        store(dDualLow, rows.dDualLow, i);
        store(dDualHigh, rows.dDualHigh, i);
        loss.raise(vector, hn::Neg(partLow));
        loss.raise(vector, partHigh);
        loss.raise(vector, hn::IfThenElseZero(hn::Gt(dualLow, zero), hn::Add(one, partLow)));
        loss.raise(vector, hn::IfThenElseZero(hn::Gt(dualHigh, zero), hn::Sub(one, partHigh)));
        energy.add(vector, hn::Mul(dx, hn::Sub(dDualLow, dDualHigh)));
    });
    return {loss.largest(), energy.sum()};
}

void correct(Rows &rows, unsigned begin, unsigned end, double target, const double *weight, double *scaled) {
    const BodyTag d;
    forVectors(begin, end, [&](unsigned i, unsigned) HWY_ATTR {
        const auto dx = load(rows.dx, i), zero = hn::Zero(d), goal = hn::Set(d, target);
        const auto low = hn::IfThenElseZero(hn::Gt(load(rows.dualLow, i), zero), hn::Sub(goal, hn::Mul(dx, load(rows.dDualLow, i))));
        const auto high = hn::IfThenElseZero(hn::Gt(load(rows.dualHigh, i), zero), hn::Add(goal, hn::Mul(dx, load(rows.dDualHigh, i))));
        const auto byLow = hn::Div(low, load(rows.slackLow, i)), byHigh = hn::Div(high, load(rows.slackHigh, i));
        const auto q = hn::Sub(hn::Add(load(rows.s, i), byLow), byHigh);
        store(low, rows.dDualLow, i);
        store(high, rows.dDualHigh, i);
        store(q, rows.s, i);
        hn::StoreU(hn::Mul(q, hn::LoadU(d, weight + i)), d, scaled + i);
    });
}

Step finish(Rows &rows, unsigned begin, unsigned end, const double *change, const double *weight) {
    const BodyTag d;
    LaneSums loss;
    forVectors(begin, end, [&](unsigned i, unsigned vector) HWY_ATTR {
        const auto dx = hn::Mul(hn::Sub(load(rows.s, i), hn::LoadU(d, change + i)), hn::LoadU(d, weight + i));
        const auto dualLow = load(rows.dualLow, i), dualHigh = load(rows.dualHigh, i), zero = hn::Zero(d);
        const auto slackLow = load(rows.slackLow, i), slackHigh = load(rows.slackHigh, i);
        const auto dDualLow = hn::Sub(hn::Div(hn::Sub(load(rows.dDualLow, i), hn::Mul(dualLow, dx)), slackLow), dualLow);
        const auto dDualHigh = hn::Sub(hn::Div(hn::Add(load(rows.dDualHigh, i), hn::Mul(dualHigh, dx)), slackHigh), dualHigh);
        store(dx, rows.dx, i);
        store(dDualLow, rows.dDualLow, i);
        store(dDualHigh, rows.dDualHigh, i);
        loss.raise(vector, hn::Div(hn::Neg(dx), slackLow));
        loss.raise(vector, hn::Div(dx, slackHigh));
        loss.raise(vector, hn::IfThenElseZero(hn::Gt(dualLow, zero), hn::Div(hn::Neg(dDualLow), dualLow)));
        loss.raise(vector, hn::IfThenElseZero(hn::Gt(dualHigh, zero), hn::Div(hn::Neg(dDualHigh), dualHigh)));
    });
    return {loss.largest(), 0};
}

double advance(Rows &rows, unsigned begin, unsigned end, double length) {
    const BodyTag d;
    LaneSums products;
    forVectors(begin, end, [&](unsigned i, unsigned vector) HWY_ATTR {
        const auto part = hn::Set(d, length), zero = hn::Zero(d);
        const auto dx = hn::Mul(part, load(rows.dx, i));
        auto dualLow = load(rows.dualLow, i), dualHigh = load(rows.dualHigh, i);
        const auto hasLow = hn::Gt(dualLow, zero), hasHigh = hn::Gt(dualHigh, zero);
        const auto slackLow = hn::Add(load(rows.slackLow, i), hn::IfThenElseZero(hasLow, dx));
        const auto slackHigh = hn::Sub(load(rows.slackHigh, i), hn::IfThenElseZero(hasHigh, dx));
        dualLow = hn::Add(dualLow, hn::IfThenElseZero(hasLow, hn::Mul(part, load(rows.dDualLow, i))));
        dualHigh = hn::Add(dualHigh, hn::IfThenElseZero(hasHigh, hn::Mul(part, load(rows.dDualHigh, i))));
        store(hn::Add(load(rows.x, i), dx), rows.x, i);
        store(slackLow, rows.slackLow, i);
        store(slackHigh, rows.slackHigh, i);
        store(dualLow, rows.dualLow, i);
        store(dualHigh, rows.dualHigh, i);
        products.add(vector, hn::Add(hn::Mul(dualLow, slackLow), hn::Mul(dualHigh, slackHigh)));
    });
    return products.sum();
}

}  // namespace HWY_NAMESPACE
}  // namespace dxFastStepKernels
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxFastStepKernels {
HWY_EXPORT(prepare);
HWY_EXPORT(predict);
HWY_EXPORT(correct);
HWY_EXPORT(finish);
HWY_EXPORT(advance);
}  // namespace dxFastStepKernels

void dxInteriorRows::resize(unsigned rows, unsigned padded) {
    for (std::vector<double> *array : {&low, &high, &b, &c, &x, &dualLow, &dualHigh, &dx, &dDualLow, &dDualHigh, &s}) {
        array->resize(rows);
        array->resize(padded, 0.0);
    }
    softness.resize(rows);
    softness.resize(padded, 1.0);
    for (std::vector<double> *array : {&slackLow, &slackHigh}) {
        array->resize(rows);
        array->resize(padded, kFarLimit);
    }
}

namespace dxInteriorLoops {

void prepare(dxInteriorRows &rows, unsigned begin, unsigned end, const double *change, double *weight, double *scaled) {
    HWY_DYNAMIC_DISPATCH(dxFastStepKernels::prepare)(rows, begin, end, change, weight, scaled);
}

Step predict(dxInteriorRows &rows, unsigned begin, unsigned end, const double *change, const double *weight) {
    return HWY_DYNAMIC_DISPATCH(dxFastStepKernels::predict)(rows, begin, end, change, weight);
}

void correct(dxInteriorRows &rows, unsigned begin, unsigned end, double target, const double *weight, double *scaled) {
    HWY_DYNAMIC_DISPATCH(dxFastStepKernels::correct)(rows, begin, end, target, weight, scaled);
}

Step finish(dxInteriorRows &rows, unsigned begin, unsigned end, const double *change, const double *weight) {
    return HWY_DYNAMIC_DISPATCH(dxFastStepKernels::finish)(rows, begin, end, change, weight);
}

double advance(dxInteriorRows &rows, unsigned begin, unsigned end, double length) {
    return HWY_DYNAMIC_DISPATCH(dxFastStepKernels::advance)(rows, begin, end, length);
}

}  // namespace dxInteriorLoops

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr unsigned kMaxSteps = 100;

// Between 0.3 and 3 the number of steps is the same within a tenth; below, it grows.
constexpr double kStart = 3;

// How much of the way to the nearest limit a step goes.
constexpr double kMaxAdvance = 0.995;

// Parts of the first gap at which the rows' states are guessed and refined: the first one, and each next one of the last.
constexpr double kFirstGuess = 1e-8, kNextGuess = 1e-3, kLastGuess = 1e-26;

// The residual that is good enough, as part of the largest b and of the largest sum.
constexpr double kGoodResidual = 1e-12, kGoodRounding = 1e-15;

// The part of c times a distance that a multiplier is below where the row ends away from its limit.
constexpr double kSurelyFree = 0.1;

// The residual that is as small as it gets, as part of the largest b and sum.
constexpr double kRounding = 2 * std::numeric_limits<double>::epsilon();

}  // namespace

void dxInteriorPoint::begin(const dxBodySpaceProblem &problem, const dxEliminationOrder &order, dxPhaseRunner &phases, unsigned threads) {
    m_problem = &problem;
    m_system.begin(problem, order, phases, threads);
    m_refinement.begin(problem);
    m_best.resize(m_system.paddedRows());
    m_state.resize(m_system.paddedRows());
    m_sums.resize(m_system.rowChunks());
    m_steps.resize(m_system.rowChunks());
    low().resize(problem.rowCount);
    high().resize(problem.rowCount);
}

// Rows start as far from their limits as the largest b would push one, and in the middle between two.
void dxInteriorPoint::start() {
    const dxBodySpaceProblem &problem = *m_problem;
    double scale = 0;
    for (unsigned i = 0; i < problem.rowCount; ++i)
        if (problem.diagonal[i] > 0) scale = std::max(scale, std::fabs(problem.b[i]) / std::sqrt(problem.diagonal[i]));
    scale = scale > 0 ? kStart * scale : 1;
    m_limits = 0;
    m_rows.resize(problem.rowCount, m_system.paddedRows());
    for (unsigned i = 0; i < problem.rowCount; ++i) start(i, scale);
}

// `scale`: in units in which each row's diagonal is 1.
void dxInteriorPoint::start(unsigned i, double scale) {
    const double root = std::sqrt(m_problem->diagonal[i] > 0 ? m_problem->diagonal[i] : 1.0);
    const double low = m_rows.low[i], high = m_rows.high[i];
    const bool isFixed = low == high, hasLow = low > -kInfinity, hasHigh = high < kInfinity;
    m_rows.x[i] = isFixed             ? low
                  : hasLow && hasHigh ? low + (high - low) / 2
                  : hasLow            ? low + scale / root
                  : hasHigh           ? high - scale / root
                                      : 0;
    m_rows.slackLow[i] = hasLow && !isFixed ? m_rows.x[i] - low : kFarLimit;
    m_rows.slackHigh[i] = hasHigh && !isFixed ? high - m_rows.x[i] : kFarLimit;
    m_rows.dualLow[i] = hasLow && !isFixed ? std::min(scale * scale / m_rows.slackLow[i], scale * root) : 0;
    m_rows.dualHigh[i] = hasHigh && !isFixed ? std::min(scale * scale / m_rows.slackHigh[i], scale * root) : 0;
    m_limits += (m_rows.dualLow[i] > 0) + (m_rows.dualHigh[i] > 0);
    m_rows.dx[i] = m_rows.dDualLow[i] = m_rows.dDualHigh[i] = 0;
    m_rows.b[i] = m_problem->b[i];
    m_rows.c[i] = m_problem->c[i];
    m_rows.softness[i] = m_problem->softnessOf(i);
}

// Goes so far along the step, and finds the gap there.
void dxInteriorPoint::advance(double length) {
    m_system.forRows([&](const Rows &rows, unsigned chunk) {
        m_sums[chunk] = dxInteriorLoops::advance(m_rows, rows.begin, rows.end, length);
    });
    double sum = 0;
    for (const double part : m_sums) sum += part;
    m_gap = m_limits > 0 ? sum / m_limits : 0;
}

// Calls findPart(rows) for all chunks of rows.
template <class FindPart>
dxInteriorLoops::Step dxInteriorPoint::findStep(const FindPart &findPart) {
    m_system.forRows([&](const Rows &rows, unsigned chunk) { m_steps[chunk] = findPart(rows); });
    dxInteriorLoops::Step step;
    for (const dxInteriorLoops::Step &part : m_steps) step.add(part);
    return step;
}

// How much of a step may be taken.
double dxInteriorPoint::lengthOf(const dxInteriorLoops::Step &step) { return step.largestLoss > 1 ? 1 / step.largestLoss : 1; }

// A row ends at a limit if its distance is small beside the multiplier, in units of its diagonal, and away from it if the multiplier
// is small beside the distance, in units of its c. In between, the last step decides: it brings a row that ends there
// nearer to its limit by a larger part than it makes its multiplier smaller.
void dxInteriorPoint::guessStates() {
    for (unsigned i = 0; i < m_problem->rowCount; ++i) {
        const double diagonal = m_problem->diagonal[i], c = m_problem->c[i];
        const auto isAt = [diagonal, c](double distance, double change, double dual, double dualChange) {
            if (dual == 0) return false;
            if (dual > diagonal * distance) return true;
            if (dual < kSurelyFree * c * distance) return false;
            return change / distance < dualChange / dual;
        };
        m_state[i] = dxRowState::Free;
        m_best[i] = std::clamp(m_rows.x[i], m_rows.low[i], m_rows.high[i]);
        if (m_rows.low[i] == m_rows.high[i] || isAt(m_rows.slackLow[i], m_rows.dx[i], m_rows.dualLow[i], m_rows.dDualLow[i])) {
            m_state[i] = dxRowState::AtLow;
            m_best[i] = m_rows.low[i];
        } else if (isAt(m_rows.slackHigh[i], -m_rows.dx[i], m_rows.dualHigh[i], m_rows.dDualHigh[i])) {
            m_state[i] = dxRowState::AtHigh;
            m_best[i] = m_rows.high[i];
        }
    }
}

bool dxInteriorPoint::iterate() {
    m_system.findMotion(m_rows.x);
    m_system.forRows([&](const Rows &rows, unsigned) {
        dxInteriorLoops::prepare(m_rows, rows.begin, rows.end, m_system.changeByMotion(rows), m_system.weight(), m_system.scaled());
    });
    if (!m_system.factorise()) return false;
    const double target = predict();
    m_system.forRows([&](const Rows &rows, unsigned) {
        dxInteriorLoops::correct(m_rows, rows.begin, rows.end, target, m_system.weight(), m_system.scaled());
    });
    m_system.solveBodies();
    const double full = lengthOf(findStep([&](const Rows &rows) {
        return dxInteriorLoops::finish(m_rows, rows.begin, rows.end, m_system.changeBySolution(rows), m_system.weight());
    }));
    const double length = full < 1 ? kMaxAdvance * full : kMaxAdvance;
    if (!std::isfinite(length)) return false;
    advance(length);
    return true;
}

// The step to a target of 0. Returns the target of the corrected one. The gap after a part of this step is (1 - part) of the gap, and the
// square of the part times the mean energy.
double dxInteriorPoint::predict() {
    m_system.solveBodies();
    const dxInteriorLoops::Step step = findStep([&](const Rows &rows) {
        return dxInteriorLoops::predict(m_rows, rows.begin, rows.end, m_system.changeBySolution(rows), m_system.weight());
    });
    if (!(m_gap > 0)) return 0;
    const double length = lengthOf(step), after = (1 - length) * m_gap + length * length * step.energy / m_limits;
    const double part = std::max(after / m_gap, 0.0);
    return part * part * part * m_gap;
}

double dxInteriorPoint::solve() {
    start();
    advance(0);
    const double firstGap = m_gap;
    double residual = kInfinity;
    m_found.clear();
    double guess = m_limits > 0 ? kFirstGuess : 1;
    for (unsigned i = 0; i < kMaxSteps; ++i) {
        if (m_gap <= guess * firstGap) {
            guessStates();
            const Scale expected = scaleOf(m_best);
            const double rounding = kRounding * (expected.b + expected.sum);
            const double now = m_refinement.refine(m_system, m_rows.low, m_rows.high, rounding, m_state, m_best);
            if (now < residual) {
                residual = now;
                m_found = m_best;
            }
            const Scale scale = scaleOf(m_best);
            if (residual <= kGoodResidual * scale.b + kGoodRounding * scale.sum || m_gap <= kLastGuess * firstGap) break;
            guess = std::min(guess, m_gap / firstGap) * kNextGuess;
        }
        if (!iterate()) break;
    }
    if (residual < kInfinity) m_rows.x = m_found;
    return residual;
}

dxInteriorPoint::Scale dxInteriorPoint::scaleOf(const std::vector<double> &x) const {
    Scale scale{0, 0};
    for (unsigned i = 0; i < m_problem->rowCount; ++i) {
        scale.b = std::max(scale.b, std::fabs(m_problem->b[i]));
        scale.sum = std::max(scale.sum, m_problem->diagonal[i] * std::fabs(x[i]));
    }
    return scale;
}

// s of it, too.
void dxInteriorPoint::snapToLimits(std::vector<double> &x) {
    for (unsigned i = 0; i < m_problem->rowCount; ++i) x[i] = dxSnapToLimit(x[i], m_rows.low[i], m_rows.high[i]);
    m_system.findResidual(x, m_rows.s);
}

double dxInteriorPoint::residualOf(std::vector<double> &x) {
    snapToLimits(x);
    return dxWorstKktResidual(x, m_rows.s, m_rows.low, m_rows.high);
}

double dxInteriorPoint::energyOf(std::vector<double> &x) {
    snapToLimits(x);
    double energy = 0;
    for (unsigned i = 0; i < m_problem->rowCount; ++i) {
        const double unit = m_problem->diagonal[i] + m_problem->c[i];
        if (unit == 0) continue;  // no force changes anything in this row
        const double residual = dxKktResidual(x[i], -m_rows.s[i], m_rows.low[i], m_rows.high[i]);
        energy += residual * residual / unit + m_rows.s[i] * 0;
    }
    return std::isfinite(energy) ? energy : kInfinity;
}
#endif
