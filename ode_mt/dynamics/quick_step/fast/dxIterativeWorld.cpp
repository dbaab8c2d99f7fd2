#include "dynamics/quick_step/fast/dxIterativeWorld.h"

#include <utility>

#include "dynamics/quick_step/fast/dxWarmStart.h"
#include "threading/process/dxPerWorld.h"
#include "threading/process/dxProcessObject.h"

namespace {

dxProcessObject<dxPerWorld<std::unique_ptr<dxIterativeWorld>>> worlds;

}  // namespace

dxIterativeWorld &dxIterativeWorld::of(const dxWorld *world) {
    dxIterativeWorld *found = nullptr;
    worlds->visitOrMake(world, [] { return std::make_unique<dxIterativeWorld>(); },
                        [&found](const std::unique_ptr<dxIterativeWorld> &own) { found = own.get(); });
    return *found;
}

void dxIterativeWorld::forget(const dxWorld *world) { worlds->forget(world); }

void dxIterativeWorld::release() { worlds->clear(); }

void dxIterativeWorld::begin(const dxWorldProcessIslandsInfo &info, const dxSolverChoice &choice, dReal stepSize) {
    m_choice = choice;
    m_choice.isWarm &= dxWarmStart::isLike(stepSize, std::exchange(m_stepSize, stepSize));
    m_idle.clear();
    for (const std::unique_ptr<dxIterativeSolver> &solver : m_solvers) m_idle.push_back(solver.get());
    m_forces.begin(info, m_choice.isWarm);
}

void dxIterativeWorld::provideSolvers(unsigned count) {
    while (m_solvers.size() < count) addSolver();
    dxIterativeSolver &first = *m_solvers.front();
    for (const std::unique_ptr<dxIterativeSolver> &solver : m_solvers) first.reserveAs(*solver);
    for (const std::unique_ptr<dxIterativeSolver> &solver : m_solvers) solver->reserveAs(first);
}

void dxIterativeWorld::addSolver() {
    m_idle.reserve(m_solvers.size() + 1);
    m_solvers.push_back(std::make_unique<dxIterativeSolver>());
    m_idle.push_back(m_solvers.back().get());
}

dxIterativeSolver *dxIterativeWorld::take() {
    const std::lock_guard<std::mutex> hold(m_mutex);
    if (m_idle.empty()) addSolver();
    dxIterativeSolver *const solver = m_idle.back();
    m_idle.pop_back();
    return solver;
}

void dxIterativeWorld::giveBack(dxIterativeSolver *solver) noexcept {
    const std::lock_guard<std::mutex> hold(m_mutex);
    m_idle.push_back(solver);
}
