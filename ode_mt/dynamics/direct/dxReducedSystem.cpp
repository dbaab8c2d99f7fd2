#include "dynamics/direct/dxReducedSystem.h"

#include "dynamics/direct/dxRowProducts.h"

void dxReducedSystem::begin(const dxDirectProblem &problem, const dxEliminationOrder &order) {
    m_problem = &problem;
    m_factor.shape(order);
    m_weight.resize(problem.rowCount);
    m_change.resize(problem.rowCount);
    m_force.resize(problem.bodyCount);
    m_motion.resize(problem.bodyCount);
    m_factorisations = 0;
}

bool dxReducedSystem::factorise(const std::vector<double> &d) {
    for (unsigned i = 0; i < m_problem->rowCount; ++i) m_weight[i] = 1 / d[i];
    dxRowProducts::makeMatrix(*m_problem, m_weight, m_factor);
    ++m_factorisations;
    return m_factor.factorise();
}

void dxReducedSystem::solve(const std::vector<double> &q, std::vector<double> &dx) {
    const unsigned rows = m_problem->rowCount;
    for (unsigned i = 0; i < rows; ++i) dx[i] = q[i] * m_weight[i];
    dxRowProducts::multiplyTransposed(*m_problem, dx, m_force);
    m_factor.solve(m_force);
    dxRowProducts::multiply(*m_problem, m_force, m_change);
    for (unsigned i = 0; i < rows; ++i) dx[i] = (q[i] - m_change[i]) * m_weight[i];
}

void dxReducedSystem::findResidual(const std::vector<double> &x, std::vector<double> &s) {
    dxRowProducts::multiplyTransposed(*m_problem, x, m_force);
    dxRowProducts::multiplyBodies(m_problem->inverseMass, m_force, m_motion);
    dxRowProducts::multiply(*m_problem, m_motion, m_change);
    for (unsigned i = 0; i < m_problem->rowCount; ++i)
        s[i] = m_problem->b[i] - m_change[i] - m_problem->c[i] * x[i];
}
