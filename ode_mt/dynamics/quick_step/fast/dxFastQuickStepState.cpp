#include "dynamics/quick_step/fast/dxFastQuickStepState.h"

#include <algorithm>
#include <utility>

dxFastQuickStepState &dxFastQuickStepState::of(dxWorldState &state) {
    if (state.fastQuickStep == nullptr) state.fastQuickStep = std::make_unique<dxFastQuickStepState>();
    return static_cast<dxFastQuickStepState &>(*state.fastQuickStep);
}

void dxFastQuickStepState::begin(const dxWorldProcessIslandsInfo &info, const dxSolverChoice &choice, dReal stepSize) {
    m_choice = choice;
    m_choice.isWarm &= dxContactCache::isSimilar(stepSize, std::exchange(m_stepSize, stepSize));
    m_step = m_step < dxKeptJointForces::kLastStep ? m_step + 1 : 1;
    m_idle.clear();
    for (const std::unique_ptr<dxPgsSolver> &solver : m_solvers) m_idle.push_back(solver.get());
    m_cache.begin(info, m_choice.isWarm);
}

void dxFastQuickStepState::provideSolvers(unsigned count) {
    while (m_solvers.size() < count) addSolver();
    std::size_t bytes = 0;
    unsigned threads = 0;
    for (const std::unique_ptr<dxPgsSolver> &solver : m_solvers) {
        bytes = std::max(bytes, solver->memory());
        threads = std::max(threads, solver->threads());
    }
    for (const std::unique_ptr<dxPgsSolver> &solver : m_solvers) solver->reserve(bytes, threads);
}

void dxFastQuickStepState::addSolver() {
    m_idle.reserve(m_solvers.size() + 1);
    m_solvers.push_back(std::make_unique<dxPgsSolver>());
    m_idle.push_back(m_solvers.back().get());
}

dxPgsSolver *dxFastQuickStepState::take() {
    const std::lock_guard<std::mutex> hold(m_mutex);
    if (m_idle.empty()) addSolver();
    dxPgsSolver *const solver = m_idle.back();
    m_idle.pop_back();
    return solver;
}

void dxFastQuickStepState::giveBack(dxPgsSolver *solver) noexcept {
    const std::lock_guard<std::mutex> hold(m_mutex);
    m_idle.push_back(solver);
}
