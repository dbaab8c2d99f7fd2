// What a world whose solver is "fast" keeps from dWorldQuickStep to dWorldQuickStep: the warm-start cache, and the memory of its solvers.
//
// Threading: one step of a world at a time, as upstream; several threads of that step may take solvers. Each world has its own state.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "dynamics/quick_step/fast/dxContactCache.h"
#include "dynamics/quick_step/fast/dxPgsSolver.h"
#include "settings/dxKeptJointForces.h"
#include "settings/dxWorldState.h"

class dxFastQuickStepState final : public dxWorldPart {
public:
    // Returns the world's, which is made at its first use. Throws std::bad_alloc. One step of the world at a time.
    static dxFastQuickStepState &of(dxWorldState &state);

    // Begins a step. Solvers that the last step did not give back, since user code left it, are there again. Throws std::bad_alloc. Forces
    // of a step of quite another size are not used.
    void begin(const dxWorldProcessIslandsInfo &info, const dxSolverChoice &choice, dReal stepSize);

    // Provides this number of solvers. All get as much memory as the largest has: which of them gets which group
    // is a matter of scheduling. Throws std::bad_alloc.
    void provideSolvers(unsigned count);

    dxContactCache &cache() { return m_cache; }
    bool isWarm() const { return m_choice.isWarm; }
    double tolerance() const { return m_choice.tolerance; }

    // Numbers of this step and the last one, as joints keep them (dxKeptJointForces).
    unsigned step() const { return m_step; }
    unsigned lastStep() const { return m_step > 1 ? m_step - 1 : dxKeptJointForces::kLastStep; }

    // A solver until the end of the scope. Throws std::bad_alloc.
    class Lease {
    public:
        explicit Lease(dxFastQuickStepState &state) : m_state(state), m_solver(state.take()) {}
        ~Lease() { m_state.giveBack(m_solver); }
        Lease(const Lease &) = delete;
        Lease &operator=(const Lease &) = delete;

        dxPgsSolver *operator->() const { return m_solver; }

    private:
        dxFastQuickStepState &m_state;
        dxPgsSolver *const m_solver;
    };

private:
    void addSolver();
    dxPgsSolver *take();
    void giveBack(dxPgsSolver *solver) noexcept;

    dxContactCache m_cache;
    dxSolverChoice m_choice;
    dReal m_stepSize = 0;
    unsigned m_step = 0;
    std::mutex m_mutex;  // of the rest
    std::vector<std::unique_ptr<dxPgsSolver>> m_solvers;
    std::vector<dxPgsSolver *> m_idle;  // has room for all
};
