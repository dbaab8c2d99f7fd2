// The last digits of a solution: rows that end at a limit are known, or nearly, and the others are found by solving w = 0. The
// solution is corrected by residuals of the problem itself until they grow no smaller (iterative refinement; Higham, "Accuracy and
// Stability of Numerical Algorithms", chapter 12): one solve leaves 1e-6 of b, since the condition of H is that of 1/c, two
// leave rounding.
//
// Rows whose c is 0, or too small to be added to the diagonal of J inv(M) J', are solved with a small one instead. The
// corrections then make up for it (proximal point method; Rockafellar, "Augmented Lagrangians and applications of the proximal point
// algorithm in convex programming", 1976): where rows contradict one another there is no solution, and where they repeat one another, it
// is not unique, and J' x is.
#pragma once

#include <vector>

#include "dynamics/world_step/fast/dxNormalEquations.h"

// Where a row stands.
enum class dxRowState : unsigned char { Free, AtLow, AtHigh };

class dxRefinement {
public:
    void begin(const dxBodySpaceProblem &problem);

    // From `x` on, with rows in `state`. A row that would pass a limit stays there; one that is pushed away from it is set
    // free, as long as such rows are few. Ends at a residual of `enough`. Writes `x`, as good as it was found. Returns its
    // residual, infinity for none.
    double refine(dxNormalEquations &system, const std::vector<double> &low, const std::vector<double> &high, double enough,
                  std::vector<dxRowState> &state, std::vector<double> &x);

private:
    unsigned updateStates(const std::vector<double> &low, const std::vector<double> &high, const std::vector<double> &x,
                          double tolerance, std::vector<dxRowState> &state) const;
    bool factorise(dxNormalEquations &system, const std::vector<dxRowState> &state);

    const dxBodySpaceProblem *m_problem = nullptr;
    std::vector<double> m_s, m_d, m_dx, m_best;
};
