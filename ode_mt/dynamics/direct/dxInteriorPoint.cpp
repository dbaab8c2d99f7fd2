#include "dynamics/direct/dxInteriorPoint.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics/direct/dxKktResidual.h"

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The distance to a limit that there is not: nothing compares with it, and 0 times it is 0.
constexpr double kFar = 1e300;

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

void dxInteriorPoint::begin(const dxDirectProblem &problem, const dxEliminationOrder &order) {
    m_problem = &problem;
    m_system.begin(problem, order);
    m_refinement.begin(problem);
    for (std::vector<double> *array : {&m_low, &m_high, &m_x, &m_best, &m_toLow, &m_toHigh, &m_pullLow, &m_pullHigh, &m_dx,
                                       &m_dPullLow, &m_dPullHigh, &m_s, &m_d, &m_q})
        array->resize(problem.rowCount);
    m_state.resize(problem.rowCount);
}

// Rows start as far from their limits as the largest b would push one, and in the middle between two.
void dxInteriorPoint::start() {
    const dxDirectProblem &problem = *m_problem;
    double scale = 0;
    for (unsigned i = 0; i < problem.rowCount; ++i)
        if (problem.diagonal[i] > 0) scale = std::max(scale, std::fabs(problem.b[i]) / std::sqrt(problem.diagonal[i]));
    scale = scale > 0 ? kStart * scale : 1;
    m_limits = 0;
    for (unsigned i = 0; i < problem.rowCount; ++i) start(i, scale);
}

// `scale`: in units in which each row's diagonal is 1.
void dxInteriorPoint::start(unsigned i, double scale) {
    const double root = std::sqrt(m_problem->diagonal[i] > 0 ? m_problem->diagonal[i] : 1.0);
    const double low = m_low[i], high = m_high[i];
    const bool isFixed = low == high, hasLow = low > -kInfinity, hasHigh = high < kInfinity;
    m_x[i] = isFixed             ? low
             : hasLow && hasHigh ? low + (high - low) / 2
             : hasLow            ? low + scale / root
             : hasHigh           ? high - scale / root
                                 : 0;
    m_toLow[i] = hasLow && !isFixed ? m_x[i] - low : kFar;
    m_toHigh[i] = hasHigh && !isFixed ? high - m_x[i] : kFar;
    m_pullLow[i] = hasLow && !isFixed ? std::min(scale * scale / m_toLow[i], scale * root) : 0;
    m_pullHigh[i] = hasHigh && !isFixed ? std::min(scale * scale / m_toHigh[i], scale * root) : 0;
    m_limits += (m_pullLow[i] > 0) + (m_pullHigh[i] > 0);
}

// The gap of x and the multipliers after a part of the step.
double dxInteriorPoint::gapAfter(double length) const {
    double sum = 0;
    for (unsigned i = 0; i < m_problem->rowCount; ++i)
        sum += (m_pullLow[i] + length * m_dPullLow[i]) * (m_toLow[i] + length * m_dx[i]) +
               (m_pullHigh[i] + length * m_dPullHigh[i]) * (m_toHigh[i] - length * m_dx[i]);
    return m_limits > 0 ? sum / m_limits : 0;
}

// Only a new largest part is divided: those are few.
double dxInteriorPoint::findStepLength() const {
    double inverse = 0;  // the largest part of a distance or multiplier that the step takes
    const auto take = [&inverse](double loss, double of) {
        if (loss > inverse * of) inverse = loss / of;
    };
    for (unsigned i = 0; i < m_problem->rowCount; ++i) {
        take(-m_dx[i], m_toLow[i]);
        take(m_dx[i], m_toHigh[i]);
        if (m_pullLow[i] > 0) take(-m_dPullLow[i], m_pullLow[i]);
        if (m_pullHigh[i] > 0) take(-m_dPullHigh[i], m_pullHigh[i]);
    }
    return inverse > 1 ? 1 / inverse : 1;
}

// The step to a target of 0.
void dxInteriorPoint::predict() {
    m_system.solve(m_s, m_dx);
    for (unsigned i = 0; i < m_problem->rowCount; ++i) {
        m_dPullLow[i] = -m_pullLow[i] - m_pullLow[i] / m_toLow[i] * m_dx[i];
        m_dPullHigh[i] = -m_pullHigh[i] + m_pullHigh[i] / m_toHigh[i] * m_dx[i];
    }
}

// The step to `target`, corrected by the products that the predicted one left out.
void dxInteriorPoint::correct(double target) {
    for (unsigned i = 0; i < m_problem->rowCount; ++i) {
        m_dPullLow[i] = m_pullLow[i] > 0 ? target - m_dx[i] * m_dPullLow[i] : 0;
        m_dPullHigh[i] = m_pullHigh[i] > 0 ? target + m_dx[i] * m_dPullHigh[i] : 0;
        m_q[i] = m_s[i] + m_dPullLow[i] / m_toLow[i] - m_dPullHigh[i] / m_toHigh[i];
    }
    m_system.solve(m_q, m_dx);
    for (unsigned i = 0; i < m_problem->rowCount; ++i) {
        m_dPullLow[i] = (m_dPullLow[i] - m_pullLow[i] * m_dx[i]) / m_toLow[i] - m_pullLow[i];
        m_dPullHigh[i] = (m_dPullHigh[i] + m_pullHigh[i] * m_dx[i]) / m_toHigh[i] - m_pullHigh[i];
    }
}

void dxInteriorPoint::advance(double length) {
    for (unsigned i = 0; i < m_problem->rowCount; ++i) {
        const double dx = length * m_dx[i];
        m_x[i] += dx;
        if (m_pullLow[i] > 0) {
            m_toLow[i] += dx;
            m_pullLow[i] += length * m_dPullLow[i];
        }
        if (m_pullHigh[i] > 0) {
            m_toHigh[i] -= dx;
            m_pullHigh[i] += length * m_dPullHigh[i];
        }
    }
}

// A row ends at a limit if its distance is small beside the multiplier, in units of its diagonal, and away from it if the multiplier
// is small beside the distance, in units of its c. In between, the last step decides: it brings a row that ends there
// nearer to its limit by a larger part than it makes its multiplier smaller.
void dxInteriorPoint::guessStates() {
    for (unsigned i = 0; i < m_problem->rowCount; ++i) {
        const double diagonal = m_problem->diagonal[i], c = m_problem->c[i];
        const auto isAt = [diagonal, c](double distance, double change, double pull, double pullChange) {
            if (pull == 0) return false;
            if (pull > diagonal * distance) return true;
            if (pull < kSurelyFree * c * distance) return false;
            return change / distance < pullChange / pull;
        };
        m_state[i] = dxRowState::Free;
        m_best[i] = std::clamp(m_x[i], m_low[i], m_high[i]);
        if (m_low[i] == m_high[i] || isAt(m_toLow[i], m_dx[i], m_pullLow[i], m_dPullLow[i])) {
            m_state[i] = dxRowState::AtLow;
            m_best[i] = m_low[i];
        } else if (isAt(m_toHigh[i], -m_dx[i], m_pullHigh[i], m_dPullHigh[i])) {
            m_state[i] = dxRowState::AtHigh;
            m_best[i] = m_high[i];
        }
    }
}

bool dxInteriorPoint::iterate() {
    const dxDirectProblem &problem = *m_problem;
    m_system.findResidual(m_x, m_s);
    for (unsigned i = 0; i < problem.rowCount; ++i)
        m_d[i] = m_low[i] == m_high[i] ? kInfinity
                                       : problem.softnessOf(i) + m_pullLow[i] / m_toLow[i] +
                                             m_pullHigh[i] / m_toHigh[i];
    if (!m_system.factorise(m_d)) return false;
    predict();
    const double aff = findStepLength();
    const double part = m_gap > 0 ? gapAfter(aff) / m_gap : 0;
    correct(part * part * part * m_gap);
    const double full = findStepLength();
    const double length = full < 1 ? kMaxAdvance * full : kMaxAdvance;
    if (!std::isfinite(length)) return false;
    advance(length);
    return true;
}

double dxInteriorPoint::solve() {
    start();
    for (double *d : {m_dx.data(), m_dPullLow.data(), m_dPullHigh.data()}) std::fill_n(d, m_problem->rowCount, 0.0);
    m_gap = gapAfter(0);
    const double firstGap = m_gap;
    double residual = kInfinity;
    m_found.clear();
    double guess = m_limits > 0 ? kFirstGuess : 1;
    for (unsigned i = 0; i < kMaxSteps; ++i) {
        if (m_gap <= guess * firstGap) {
            guessStates();
            const Scale expected = scaleOf(m_best);
            const double rounding = kRounding * (expected.b + expected.sum);
            const double now = m_refinement.refine(m_system, m_low, m_high, rounding, m_state, m_best);
            if (now < residual) {
                residual = now;
                m_found = m_best;
            }
            const Scale scale = scaleOf(m_best);
            if (residual <= kGoodResidual * scale.b + kGoodRounding * scale.sum || m_gap <= kLastGuess * firstGap) break;
            guess = std::min(guess, m_gap / firstGap) * kNextGuess;
        }
        if (!iterate()) break;
        m_gap = gapAfter(0);
    }
    if (residual < kInfinity) m_x = m_found;
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

double dxInteriorPoint::residualOf(std::vector<double> &x) {
    for (unsigned i = 0; i < m_problem->rowCount; ++i) x[i] = dxSnapToLimit(x[i], m_low[i], m_high[i]);
    m_system.findResidual(x, m_s);
    return dxWorstKktResidual(x, m_s, m_low, m_high);
}
