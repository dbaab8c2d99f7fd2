#include "settings/dxWorldSolver.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <utility>
#include <vector>

#include "threading/process/dxForkLocks.h"
#include "threading/process/dxProcessObject.h"

namespace dxWorldSolver {

namespace {

struct Choices {
    using Choice = std::pair<const dxWorld *, dxSolverChoice>;

    std::vector<Choice>::iterator find(const dxWorld *world) {
        return std::find_if(list.begin(), list.end(), [world](const Choice &choice) { return choice.first == world; });
    }

    // The world's own, which begins as the process's. Requires the mutex.
    dxSolverChoice &own(const dxWorld *world) {
        const auto found = find(world);
        if (found != list.end()) return found->second;
        list.emplace_back(world, dxSettings::instance().solver());
        count();
        return list.back().second;
    }

    // Requires the mutex.
    void count() { size.store(list.size(), std::memory_order_release); }

    dxForkSafeMutex mutex;
    std::vector<Choice> list;
    std::atomic<std::size_t> size{0};  // of the list: most processes have none
};

dxProcessObject<Choices> choices;

}  // namespace

dxSolverChoice of(const dxWorld *world) {
    if (choices->size.load(std::memory_order_acquire) == 0) return dxSettings::instance().solver();
    const std::lock_guard<dxForkSafeMutex> hold(choices->mutex);
    const auto found = choices->find(world);
    return found != choices->list.end() ? found->second : dxSettings::instance().solver();
}

bool choose(const dxWorld *world, const std::string &name) {
    dxSolver solver = dxSolver::Exact;
    if (!dxSettings::readSolver(name, solver)) return false;
    if (solver != dxSolver::Exact) dxSettings::instance().allowFast();
    const std::lock_guard<dxForkSafeMutex> hold(choices->mutex);
    choices->own(world).solver = solver;
    return true;
}

void setTolerance(const dxWorld *world, double tolerance) {
    const std::lock_guard<dxForkSafeMutex> hold(choices->mutex);
    choices->own(world).tolerance = tolerance;
}

void setWarmStart(const dxWorld *world, bool isWarm) {
    const std::lock_guard<dxForkSafeMutex> hold(choices->mutex);
    choices->own(world).isWarm = isWarm;
}

void forget(const dxWorld *world) {
    const std::lock_guard<dxForkSafeMutex> hold(choices->mutex);
    const auto found = choices->find(world);
    if (found == choices->list.end()) return;
    choices->list.erase(found);
    choices->count();
    if (choices->list.empty()) choices->list.shrink_to_fit();  // what is kept would be lost with an unloading
}

}  // namespace dxWorldSolver
