// What the library keeps beside a world, which is upstream's structure: the world's own settings, statistics of its last frame, and what
// its solver remembers from step to step. There is one object for a world, made when something is first kept for it; it ends with the world.
//
// A step reads its world's settings (dxWorldSettings::of) before it takes memory for its islands, and again when it begins to step them; from there
// on they are passed (dxStepCall). The statistics read the number of threads at the end. Finding a world takes no lock for the first thousand worlds
// that have a state.
//
// Threading: any thread may call. The solver must not be changed while its world is stepped, not even by the world's memory functions:
// the step has taken memory for the previous solver. As in upstream, a world must not be destroyed by one thread and used by another.
//
// Dropped: a list for each kind of state, with a mutex and a search of its own. A step locked up to five of them.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <string>

#include <ode/ode.h>

#include "settings/dxOwnThreads.h"
#include "settings/dxSettings.h"
#include "threading/process/dxFork.h"

// What another file keeps in the state of a world. That file knows the type.
class dxWorldPart {
public:
    virtual ~dxWorldPart() = default;
};

class dxWorldState {
public:
    // Returns null if nothing is kept for the world.
    static dxWorldState *find(const dxWorld *world);

    // Makes the state if there is none. Throws std::bad_alloc, and changes nothing then.
    static dxWorldState &of(const dxWorld *world);

    // Called before the world is destroyed.
    static void forget(const dxWorld *world);

    // Calls visit(state) for the states of all worlds, under lock().
    template <class Visit>
    static void forAll(const Visit &visit) {
        forAllStates([](dxWorldState &state, const void *visiting) { (*static_cast<const Visit *>(visiting))(state); }, &visit);
    }

    // Guards the frames of all worlds. Taken for moments; survives fork.
    static dxForkSafeMutex &lock();

    dxWorldState();
    dxWorldState(const dxWorldState &) = delete;
    dxWorldState &operator=(const dxWorldState &) = delete;

    // A world's own choice begins as the process's.
    dxSolverChoice solver() const;
    void setSolver(dxSolver solver) { m_solver.store(solver, std::memory_order_relaxed); }
    void setTolerance(double tolerance) { m_tolerance.store(tolerance, std::memory_order_relaxed); }  // from 0 to 1
    void setWarmStart(bool isWarm) { m_isWarm.store(isWarm, std::memory_order_relaxed); }

    dxOwnThreadNumber threads;
    std::atomic<unsigned> solvingLimit{dWORLDSTEP_THREADCOUNT_UNLIMITED};  // dxWorldSettings

    std::unique_ptr<dxWorldPart> frames;         // dxWorldStatistics, under lock()
    std::unique_ptr<dxWorldPart> fastQuickStep;  // dxFastQuickStepState; one step of a world at a time

private:
    static void forAllStates(void (*visit)(dxWorldState &, const void *), const void *visiting);

    std::atomic<dxSolver> m_solver;
    std::atomic<double> m_tolerance;
    std::atomic<bool> m_isWarm;
};

// The settings of a world at one moment: its own, or else the process's.
struct dxWorldSettings {
    dxSolverChoice solver;
    unsigned threads = 0;  // its own number; 0: the process's

    // Threads that may solve one island, where the program has set that (dWSTP_LCPSolvingMaxThreads).
    unsigned solvingLimit = dWORLDSTEP_THREADCOUNT_UNLIMITED;

    static dxWorldSettings of(const dxWorld *world);

    bool isFast() const { return solver.solver == dxSolver::Fast; }
    unsigned threadsInForce() const { return dxOwnThreads::inForce(threads); }
};

// Sets the solver of a world by its name. Returns false for an unknown one, which is reported with dMessage. Throws std::bad_alloc, and changes
// nothing then; so do the following.
bool dxSetSolver(const dxWorld *world, const std::string &name);

// 0: the process's number.
void dxSetThreads(const dxWorld *world, unsigned threads);

void dxSetSolvingLimit(const dxWorld *world, unsigned threads);
