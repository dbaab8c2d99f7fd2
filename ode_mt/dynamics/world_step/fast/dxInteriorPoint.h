// One of the two convex problems of an island (dxBodySpaceProblem.h): all limits are fixed.
//
// Primal-dual interior-point method: x stays strictly between its limits, at distances l and h from them, and each limit has a
// multiplier z of its own, so that w = zl - zh. Newton's method is applied to  J u + c x - b = zl - zh,  zl l = zh h = target,  M u = J' x
// while the target goes to 0. With the multipliers eliminated, a step is  (J inv(M) J' + D) dx = q  with  D = c + zl / l + zh / h,
// and in body space  H du = J' inv(D) q,  dx = inv(D) (q - J du)  with  H = M + J' inv(D) J:  the pattern of H is that of the
// bodies' graph, whatever the limits do, so one symbolic factorisation serves all steps.
//
// Sources: Mehrotra, "On the implementation of a primal-dual interior point method", SIAM Journal on Optimization 2, 1992 (predictor,
// corrector, target); El-Bakry, Tapia and Zhang, "A study of indicators for identifying zero variables in interior-point
// methods", SIAM Review 36, 1994 (which rows end at a limit).
//
// Once the distances and multipliers tell which rows end at a limit, these are put there, and the others are found by solving
// w = 0: with x corrected by residuals of the problem itself, J inv(M) J' x + c x - b, since H has the condition of 1/c (dxRefinement.h).
//
// Tried and dropped: semismooth Newton with exact line search on F(u), along a ladder of c = 1e-2 ... 1e-7 of the diagonal, each level
// beginning with the last one's free rows: 100 to 250 factorisations for the friction of a wall of 100 bricks, and no end
// within 250 for the settled one, where this method takes 20 to 35. (Levels that begin with the last one's u, without its free
// rows, failed for a humanoid: x = (b - J u) / c grows tenfold, and nearly all rows go to a limit.)
#pragma once

#include <vector>

#include "dynamics/world_step/fast/dxBodySpaceProblem.h"
#include "dynamics/world_step/fast/dxNormalEquations.h"
#include "dynamics/world_step/fast/dxRefinement.h"

// The distance to a limit that there is not: nothing compares with it, and 0 times it is 0.
constexpr double kFarLimit = 1e300;

// The numbers that the method has of each row. All arrays have a multiple of kBodyLanes elements, and so have ranges.
struct dxInteriorRows {
    std::vector<double> low, high;              // limits; equal: fixed
    std::vector<double> b, c, softness;         // dxBodySpaceProblem
    std::vector<double> x;
    std::vector<double> slackLow, slackHigh;          // distances; kFarLimit where there is no limit
    std::vector<double> dualLow, dualHigh;      // multipliers; 0 where there is no limit
    std::vector<double> dx, dDualLow, dDualHigh;  // of a step
    std::vector<double> s;                      // b - (J inv(M) J' + c) x

    // `padded` elements, of which those from `rows` on are fixed at 0. The others keep their values. Throws std::bad_alloc.
    void resize(unsigned rows, unsigned padded);
};

// Its loops over rows. The bits do not depend on the instruction set: sums are over as many lanes as kBodyLanes, in the order of the rows.
namespace dxInteriorLoops {

// Of a step, or of a part of its rows.
struct Step {
    double largestLoss = 0;  // of all distances and multipliers, the largest part of one that the step takes
    double energy = 0;       // the sum of changes of distances times changes of multipliers

    // Both parts, in the order in which they are added.
    void add(const Step &other) {
        if (other.largestLoss > largestLoss) largestLoss = other.largestLoss;
        energy += other.energy;
    }
};

// s for J inv(M) J' x = `change`; the weights inv(D) for D = c + zl / l + zh / h, 0 where a row is fixed; s times them.
void prepare(dxInteriorRows &rows, unsigned begin, unsigned end, const double *change, double *weight, double *scaled);

// The step to a target of 0, for J du = `change`.
Step predict(dxInteriorRows &rows, unsigned begin, unsigned end, const double *change, const double *weight);

// The right-hand side of the step to `target`, corrected by the products that the predicted one left out, times the weights.
void correct(dxInteriorRows &rows, unsigned begin, unsigned end, double target, const double *weight, double *scaled);

// That step, for J du = `change`.
Step finish(dxInteriorRows &rows, unsigned begin, unsigned end, const double *change, const double *weight);

// Goes a part of the step. Returns the sum of all products of distances and multipliers then.
double advance(dxInteriorRows &rows, unsigned begin, unsigned end, double length);

}  // namespace dxInteriorLoops

class dxInteriorPoint {
public:
    // `order`: of the problem's bodies. All outlive what follows. At most `threads` threads share the phases. Throws std::bad_alloc.
    void begin(const dxBodySpaceProblem &problem, const dxEliminationOrder &order, dxPhaseRunner &phases, unsigned threads);

    // The limits of this problem, to be written before solve; low <= high.
    std::vector<double> &low() { return m_rows.low; }
    std::vector<double> &high() { return m_rows.high; }

    // Writes x. Returns its residual (dxResidual.h); infinity if numbers left the range of doubles.
    double solve();

    const std::vector<double> &x() const { return m_rows.x; }

    // What rounding makes of a residual: the largest b, and the largest sum that w is the rest of.
    struct Scale {
        double b, sum;
    };
    Scale scaleOf(const std::vector<double> &x) const;

    // The residual of any x under the limits in force. A force next to a limit, as rounding may leave it, is put there.
    double residualOf(std::vector<double> &x);

    // The energy of the residual of x: the sum of its squares, each in units of its row's diagonal and c. Infinity if a number is not finite.
    double energyOf(std::vector<double> &x);

    // Takes back what solve has found before.
    void take(const std::vector<double> &x) { m_rows.x = x; }

    // Since begin: factorisations.
    unsigned factorisations() const { return m_system.factorisations(); }

private:
    using Rows = dxProblemChunks::Rows;

    void snapToLimits(std::vector<double> &x);
    void start();
    void start(unsigned row, double scale);
    bool iterate();
    double predict();
    template <class FindPart>
    dxInteriorLoops::Step findStep(const FindPart &findPart);
    static double lengthOf(const dxInteriorLoops::Step &step);
    void advance(double length);
    void guessStates();

    const dxBodySpaceProblem *m_problem = nullptr;
    dxNormalEquations m_system;
    dxRefinement m_refinement;
    dxInteriorRows m_rows;
    std::vector<double> m_best, m_found;         // x, refined: the last one, the best one
    std::vector<dxRowState> m_state;
    std::vector<double> m_sums;                  // by chunk of rows
    std::vector<dxInteriorLoops::Step> m_steps;  // by chunk of rows
    double m_gap = 0;       // mean of zl l and zh h
    unsigned m_limits = 0;  // of all rows
};
