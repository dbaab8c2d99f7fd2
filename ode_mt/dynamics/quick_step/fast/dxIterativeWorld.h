// What a world whose solver is "fast" keeps from step to step: the contact forces of the last one, and the memory of its solvers.
//
// Threading: one step of a world at a time, as upstream; several threads of that step may take solvers. Each world has its own.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "dynamics/quick_step/fast/dxContactForces.h"
#include "dynamics/quick_step/fast/dxIterativeSolver.h"
#include "settings/dxWorldSolver.h"

class dxIterativeWorld {
public:
    // The world's, made at its first use. Throws std::bad_alloc. Any thread.
    static dxIterativeWorld &of(const dxWorld *world);

    // The world is about to be destroyed.
    static void forget(const dxWorld *world);

    // Frees those of all worlds (unloading). No step may be in progress.
    static void release();

    // A step begins. Solvers that the last one did not give back, since user code left it, are there again. Throws
    // std::bad_alloc. Forces of a step of quite another size are not used.
    void begin(const dxWorldProcessIslandsInfo &info, const dxSolverChoice &choice, dReal stepSize);

    // So many solvers may be taken at once. Each has memory for what any of them has solved: which of them gets which group is the
    // schedule's. Throws std::bad_alloc.
    void provideSolvers(unsigned count);

    dxContactForces &forces() { return m_forces; }
    bool isWarm() const { return m_choice.isWarm; }
    double tolerance() const { return m_choice.tolerance; }

    // A solver until the end of the scope. Throws std::bad_alloc.
    class Lease {
    public:
        explicit Lease(dxIterativeWorld &world) : m_world(world), m_solver(world.take()) {}
        ~Lease() { m_world.giveBack(m_solver); }
        Lease(const Lease &) = delete;
        Lease &operator=(const Lease &) = delete;

        dxIterativeSolver *operator->() const { return m_solver; }

    private:
        dxIterativeWorld &m_world;
        dxIterativeSolver *const m_solver;
    };

private:
    void addSolver();
    dxIterativeSolver *take();
    void giveBack(dxIterativeSolver *solver) noexcept;

    dxContactForces m_forces;
    dxSolverChoice m_choice;
    dReal m_stepSize = 0;
    std::mutex m_mutex;  // of the rest
    std::vector<std::unique_ptr<dxIterativeSolver>> m_solvers;
    std::vector<dxIterativeSolver *> m_idle;  // has room for all
};
