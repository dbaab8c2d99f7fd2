#include "dynamics/world_step/fast/dxReducedSystem.h"

#include "dynamics/world_step/fast/dxRowProducts.h"

void dxReducedSystem::begin(const dxDirectProblem &problem, const dxEliminationOrder &order, dxPhaseRunner &phases, unsigned threads) {
    m_problem = &problem;
    m_order = &order;
    m_phases = &phases;
    m_chunks.make(problem);
    m_factor.shape(order, threads);
    for (std::vector<double> *array : {&m_weight, &m_scaled, &m_change}) array->assign(paddedRows(), 0);
    m_force.resize(problem.bodyCount);
    m_motion.resize(problem.bodyCount);
    m_factorisations = 0;
}

void dxReducedSystem::findMotion(const std::vector<double> &x) {
    m_phases->forChunks(static_cast<unsigned>(m_chunks.bodies().size()), [&](unsigned chunk, unsigned) {
        const dxProblemChunks::Bodies &bodies = m_chunks.bodies()[chunk];
        dxRowProducts::multiplyTransposed(*m_problem, m_chunks, bodies, x.data(), m_force);
        dxRowProducts::multiplyBodies(m_problem->inverseMass, bodies, m_force, m_motion);
    });
}

const double *dxReducedSystem::changeByMotion(const Rows &rows) {
    dxRowProducts::multiply(*m_problem, rows, m_motion, m_change.data());
    return m_change.data();
}

bool dxReducedSystem::factorise() {
    ++m_factorisations;
    return m_factor.factorise(*m_phases, [&](unsigned begin, unsigned end) {
        dxRowProducts::makeColumns(*m_problem, m_chunks, *m_order, begin, end, m_weight.data(), m_factor);
    });
}

void dxReducedSystem::solveBodies() {
    m_phases->forChunks(static_cast<unsigned>(m_chunks.bodies().size()), [&](unsigned chunk, unsigned) {
        dxRowProducts::multiplyTransposed(*m_problem, m_chunks, m_chunks.bodies()[chunk], m_scaled.data(), m_force);
    });
    m_factor.solve(*m_phases, m_force);
}

const double *dxReducedSystem::changeBySolution(const Rows &rows) {
    dxRowProducts::multiply(*m_problem, rows, m_force, m_change.data());
    return m_change.data();
}

bool dxReducedSystem::factorise(const std::vector<double> &d) {
    forRows([&](const Rows &rows, unsigned) {
        for (unsigned i = rows.begin; i < rows.end; ++i) m_weight[i] = 1 / d[i];
    });
    return factorise();
}

void dxReducedSystem::solve(const std::vector<double> &q, std::vector<double> &dx) {
    forRows([&](const Rows &rows, unsigned) {
        for (unsigned i = rows.begin; i < rows.end; ++i) m_scaled[i] = q[i] * m_weight[i];
    });
    solveBodies();
    forRows([&](const Rows &rows, unsigned) {
        const double *const change = changeBySolution(rows);
        for (unsigned i = rows.begin; i < rows.end; ++i) dx[i] = (q[i] - change[i]) * m_weight[i];
    });
}

void dxReducedSystem::findResidual(const std::vector<double> &x, std::vector<double> &s) {
    findMotion(x);
    forRows([&](const Rows &rows, unsigned) {
        const double *const change = changeByMotion(rows);
        const unsigned end = std::min(rows.end, m_problem->rowCount);
        for (unsigned i = rows.begin; i < end; ++i) s[i] = m_problem->b[i] - change[i] - m_problem->c[i] * x[i];
    });
}
