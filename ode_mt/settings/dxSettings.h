// What dToggleODE_MT and the environment set: how many threads, which algorithm, whether callbacks may run
// concurrently, which heuristics tune the clusters, how fine their grid is.
//
// Process-wide, because ODE_MT's API is (dToggleODE_MT has no world). The environment is read once, at
// the first use. A value that is not understood is reported by name, and the setting is unchanged. A value from a
// call is reported with dMessage, one from the environment, which is not the program's, in the log, so that no handler
// of the user runs while the library reads its settings.
//
// Threading: any thread.
#pragma once

#include <atomic>
#include <string>

#include "threading/process/dxProcess.h"

// Auto: parallel where that is predicted to pay; Serial: nothing; the others: all that can be parallel.
// ClusteredXxx: pairs are found by clusters, under the crossover pass of that name.
enum class dxAlgorithm {
    Auto,
    Serial,
    Lcp,
    ClusteredOriginal,
    ClusteredStatic,
    ClusteredStaticUnmerged,
    ClusteredDuplication,
    ClusteredDecluster
};

// Which near-callbacks may run at the same time: none; those of pairs that share no body; any.
enum class dxCallbackPolicy { Serial, Concurrent, Independent };

// How islands are solved: with upstream's bits, or by the fast solvers (direct, projected Gauss-Seidel).
enum class dxSolver { Exact, Fast };

// Of a world. The last two are of fast QuickStep.
struct dxSolverChoice {
    static constexpr double kDefaultTolerance = 1e-9;

    // False for NaN.
    static bool isTolerance(double tolerance) { return tolerance >= 0 && tolerance <= 1; }

    dxSolver solver = dxSolver::Exact;
    double tolerance = kDefaultTolerance;  // sweeps may end when they change forces by this part of all
    bool isWarm = true;                    // steps begin with the forces of the last one
};

// The transport to workers in other processes.
struct dxRemoteChoice {
    static constexpr unsigned kMaxWorkers = 1024;

    const char *transport = nullptr;  // null: none
    unsigned wanted = 0;              // workers to start; 0: those that are there
};

// Which heuristics tune the clusters: a set of them (dODE_MT_SetHeuristics).
enum dxHeuristicChoice : unsigned {
    dxTuneCells = 1u << 0,
    dxTuneCentre = 1u << 1,
    dxSkipCrossovers = 1u << 2,
    dxSkipDeclustering = 1u << 3,
    dxTuneThreads = 1u << 4,

    dxNoHeuristics = 0,
    dxDefaultHeuristics = dxTuneCells | dxTuneCentre | dxSkipCrossovers | dxSkipDeclustering
};

// Returns "none", or names with commas between them. The text lives as long as the library.
const char *dxNamesOfHeuristics(unsigned choice);

class dxSettings {
public:
    static dxSettings &instance();

    // Threads a step may use, the caller included, unless its world has a number of its own (dxOwnThreads.h); 0 and 1: the caller alone.
    unsigned threads() const { return m_threads.load(std::memory_order_relaxed); }
    void setThreads(unsigned threads);  // resolved
    // Returns the number that an argument of dToggleODE_MT means; counts the cores anew.
    unsigned resolveThreads(int threads);

    dxAlgorithm algorithm() const { return m_algorithm.load(std::memory_order_relaxed); }
    const char *algorithmName() const;
    // Returns the name of the crossover pass, if the algorithm clusters; else null.
    const char *passName() const;
    bool setAlgorithm(const std::string &name);  // false: unknown

    // Returns the choice for worlds that have none of their own (dxWorldState.h).
    const dxSolverChoice &solver() const { return m_solver; }
    static const char *nameOfSolver(dxSolver solver);
    static bool readSolver(const std::string &name, dxSolver &solver);  // false: unknown, reported with dMessage

    dxCallbackPolicy callbackPolicy() const { return m_callbackPolicy.load(std::memory_order_relaxed); }
    const char *callbackPolicyName() const;
    bool setCallbackPolicy(const std::string &name);  // false: unknown

    unsigned heuristics() const { return m_heuristics.load(std::memory_order_relaxed); }  // a dxHeuristicChoice
    bool setHeuristics(const std::string &names);  // false: unknown

    // Cells of the grid of clusters on each axis, within these limits (thesis 10.2); 0: tuned.
    static constexpr int kMinGridCells = 5, kMaxGridCells = 20;
    int gridCells() const { return m_gridCells.load(std::memory_order_relaxed); }
    bool setGridCells(int cells);  // false: too few or too many

    // Set by the environment alone, as processes are started before the program could set it.
    const dxRemoteChoice &remoteWorkers() const { return m_remoteWorkers; }

    // Returns the number of cores that this process might use when a number of threads was set last.
    unsigned cores() const { return m_cores.load(std::memory_order_relaxed); }

private:
    friend class dxProcessObject<dxSettings>;
    dxSettings();
    void readThreads(const char *text);
    void readAlgorithm(const char *text);
    bool chooseAlgorithm(const std::string &name);
    void readSolver(const char *text);
    void readTolerance(const char *text);
    void readWarmStart(const char *text);
    void readCallbackPolicy(const char *text);
    bool chooseCallbackPolicy(const std::string &name);
    void readHeuristics(const char *text);
    bool chooseHeuristics(const std::string &names);
    void readGridCells(const char *text);
    bool chooseGridCells(int cells);
    void readRemoteWorkers(const char *text);

    std::atomic<unsigned> m_threads{0};
    std::atomic<dxAlgorithm> m_algorithm{dxAlgorithm::Auto};
    dxSolverChoice m_solver;
    std::atomic<dxCallbackPolicy> m_callbackPolicy{dxCallbackPolicy::Serial};
    std::atomic<unsigned> m_heuristics{dxDefaultHeuristics};
    std::atomic<int> m_gridCells{0};
    dxRemoteChoice m_remoteWorkers;
    std::atomic<unsigned> m_cores;
};

extern dxProcessObject<dxSettings> dxProcessSettings;

inline dxSettings &dxSettings::instance() { return *dxProcessSettings; }
