#include "dynamics/iterative/dxIterativeWorld.h"

#include <algorithm>
#include <utility>

#include "threading/process/dxForkLocks.h"
#include "threading/process/dxProcessObject.h"

namespace {

struct Worlds {
    using Entry = std::pair<const dxWorld *, std::unique_ptr<dxIterativeWorld>>;

    std::vector<Entry>::iterator find(const dxWorld *world) {
        return std::find_if(list.begin(), list.end(), [world](const Entry &entry) { return entry.first == world; });
    }

    dxForkSafeMutex mutex;
    std::vector<Entry> list;
};

dxProcessObject<Worlds> worlds;

}  // namespace

dxIterativeWorld &dxIterativeWorld::of(const dxWorld *world) {
    const std::lock_guard<dxForkSafeMutex> hold(worlds->mutex);
    const auto found = worlds->find(world);
    if (found != worlds->list.end()) return *found->second;
    worlds->list.emplace_back(world, std::make_unique<dxIterativeWorld>());
    return *worlds->list.back().second;
}

void dxIterativeWorld::forget(const dxWorld *world) {
    const std::lock_guard<dxForkSafeMutex> hold(worlds->mutex);
    const auto found = worlds->find(world);
    if (found == worlds->list.end()) return;
    worlds->list.erase(found);
    if (worlds->list.empty()) worlds->list.shrink_to_fit();  // what is kept would be lost with an unloading
}

void dxIterativeWorld::release() {
    const std::lock_guard<dxForkSafeMutex> hold(worlds->mutex);
    worlds->list.clear();
    worlds->list.shrink_to_fit();
}

void dxIterativeWorld::begin(const dxWorldProcessIslandsInfo &info, const dxSolverChoice &choice) {
    m_choice = choice;
    m_idle.clear();
    for (const std::unique_ptr<dxIterativeSolver> &solver : m_solvers) m_idle.push_back(solver.get());
    m_forces.begin(info, choice.isWarm);
}

dxIterativeSolver *dxIterativeWorld::take() {
    const std::lock_guard<std::mutex> hold(m_mutex);
    if (m_idle.empty()) {
        m_idle.reserve(m_solvers.size() + 1);
        m_solvers.push_back(std::make_unique<dxIterativeSolver>());
        return m_solvers.back().get();
    }
    dxIterativeSolver *const solver = m_idle.back();
    m_idle.pop_back();
    return solver;
}

void dxIterativeWorld::giveBack(dxIterativeSolver *solver) noexcept {
    const std::lock_guard<std::mutex> hold(m_mutex);
    m_idle.push_back(solver);
}
