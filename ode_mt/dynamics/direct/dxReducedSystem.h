// Solves (J inv(M) J' + D) dx = q, for a diagonal matrix D > 0, in the space of bodies: H du = J' inv(D) q with H = M + J' inv(D) J, then
// dx = inv(D) (q - J du). Rows whose D is infinite get dx = 0.
#pragma once

#include <vector>

#include "dynamics/direct/dxBlockFactor.h"
#include "dynamics/direct/dxDirectProblem.h"

class dxReducedSystem {
public:
    void begin(const dxDirectProblem &problem, const dxEliminationOrder &order);

    // Returns false where H is not positive definite in this arithmetic.
    bool factorise(const std::vector<double> &d);

    void solve(const std::vector<double> &q, std::vector<double> &dx);

    // s = b - (J inv(M) J' + c) x, which is -w.
    void findResidual(const std::vector<double> &x, std::vector<double> &s);

    unsigned factorisations() const { return m_factorisations; }

private:
    const dxDirectProblem *m_problem = nullptr;
    dxBlockFactor m_factor;
    std::vector<double> m_weight;  // 1 / D
    std::vector<double> m_change;  // J du
    dxBodyVectors m_force, m_motion;
    unsigned m_factorisations = 0;
};
