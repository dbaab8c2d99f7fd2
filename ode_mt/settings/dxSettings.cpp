#include "settings/dxSettings.h"

#include <ode/error.h>
#include <ode/ode_MT.h>
#include <ode/version.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <sstream>

#include "core/dxEnvironment.h"
#include "core/dxLog.h"
#include "threading/process/dxProcessors.h"

namespace {

template <class Choice>
struct Named {
    const char *name;
    Choice choice;
};

constexpr Named<dxAlgorithm> kAlgorithms[] = {{"auto", dxAlgorithm::Auto},
                                              {"serial", dxAlgorithm::Serial},
                                              {"lcp", dxAlgorithm::Lcp},
                                              {"original", dxAlgorithm::ClusteredOriginal},
                                              {"static", dxAlgorithm::ClusteredStatic},
                                              {"static-unmerged", dxAlgorithm::ClusteredStaticUnmerged},
                                              {"duplication", dxAlgorithm::ClusteredDuplication},
                                              {"decluster", dxAlgorithm::ClusteredDecluster}};

constexpr Named<dxSolver> kSolvers[] = {{"exact", dxSolver::Exact}, {"fast", dxSolver::Fast}};

constexpr Named<dxCallbackPolicy> kCallbackPolicies[] = {{"serial", dxCallbackPolicy::Serial},
                                                         {"concurrent", dxCallbackPolicy::Concurrent},
                                                         {"independent", dxCallbackPolicy::Independent}};

template <class Choice, std::size_t N>
std::string knownNames(const Named<Choice> (&all)[N]) {
    std::string names;
    for (const Named<Choice> &known : all) names += (names.empty() ? "" : ", ") + std::string(known.name);
    return names;
}

template <class Choice, std::size_t N>
const char *nameOf(const Named<Choice> (&all)[N], Choice choice) {
    for (const Named<Choice> &known : all)
        if (known.choice == choice) return known.name;
    return "";
}

// Null: unknown.
template <class Choice, std::size_t N>
const Named<Choice> *find(const Named<Choice> (&all)[N], const std::string &name) {
    const auto found = std::find_if(all, all + N, [&name](const Named<Choice> &known) { return name == known.name; });
    return found != all + N ? found : nullptr;
}

// False: unknown.
template <class Choice, std::size_t N>
bool choose(const Named<Choice> (&all)[N], const std::string &name, std::atomic<Choice> &choice) {
    const Named<Choice> *const known = find(all, name);
    if (known != nullptr) choice.store(known->choice, std::memory_order_relaxed);
    return known != nullptr;
}

// By bit.
constexpr const char *kHeuristics[] = {"cells", "centre", "crossover", "declustering", "threads"};
constexpr unsigned kHeuristicsCount = sizeof kHeuristics / sizeof *kHeuristics;

bool addHeuristic(const std::string &name, unsigned &choice) {
    for (unsigned bit = 0; bit < kHeuristicsCount; ++bit) {
        if (name != kHeuristics[bit]) continue;
        choice |= 1u << bit;
        return true;
    }
    return false;
}

// The names of each set, made once. The object contains them: what it allocated would leak with each unloading.
struct HeuristicTexts {
    static constexpr std::size_t kMaxLength = 48;
    static_assert(sizeof "cells,centre,crossover,declustering,threads" <= kMaxLength, "all of kHeuristics");

    char of[1u << kHeuristicsCount][kMaxLength] = {"none"};

    HeuristicTexts() {
        for (unsigned choice = 1; choice < 1u << kHeuristicsCount; ++choice)
            for (unsigned bit = 0; bit < kHeuristicsCount; ++bit)
                if ((choice >> bit & 1u) != 0) append(of[choice], kHeuristics[bit]);
    }

    static void append(char *text, const char *name) {
        if (*text != '\0') std::strcat(text, ",");
        std::strcat(text, name);
    }
};

dxProcessObject<HeuristicTexts> heuristicTexts;

// Reads "default", "none", or names with commas between them. Returns false if one is unknown.
bool parseHeuristics(const std::string &names, unsigned &choice) {
    choice = names == "default" ? dxDefaultHeuristics : dxNoHeuristics;
    if (names == "default" || names == "none") return true;
    if (names.empty() || names.back() == ',') return false;
    std::istringstream stream(names);
    for (std::string name; std::getline(stream, name, ',');)
        if (!addHeuristic(name, choice)) return false;
    return true;
}

// Returns all that parseHeuristics knows.
const char *knownHeuristics() { return "default, none, cells, centre, crossover, declustering, threads"; }

constexpr int kTunedCells = 0;

// A misspelt name has no effect, which users would not notice.
void reportUnknownVariable(const char *name, const char *nearest) {
    if (nearest != nullptr)
        dxLog(dxLogLevel::Warning, "%.100s is no variable of this library, and has no effect; is %s meant?", name, nearest);
    else
        dxLog(dxLogLevel::Warning, "%.100s is no variable of this library, and has no effect", name);
}

}  // namespace

dxProcessObject<dxSettings> dxProcessSettings;

dxSettings::dxSettings() : m_cores(dxCountProcessors()) {
    // One literal: bench/platform.cpp finds the release in a library's file by it.
    dxLog(dxLogLevel::Info, "version " dODE_MT_VERSION ", made of ODE " dODE_VERSION);
    dxReportUnknownVariables(reportUnknownVariable);
    if (const char *text = dxEnvironment(dxVariable::Threads)) readThreads(text);
    if (const char *text = dxEnvironment(dxVariable::Algorithm)) readAlgorithm(text);
    if (const char *text = dxEnvironment(dxVariable::Solver)) readSolver(text);
    if (const char *text = dxEnvironment(dxVariable::SolverTolerance)) readTolerance(text);
    if (const char *text = dxEnvironment(dxVariable::WarmStart)) readWarmStart(text);
    if (const char *text = dxEnvironment(dxVariable::Callbacks)) readCallbackPolicy(text);
    if (const char *text = dxEnvironment(dxVariable::Heuristics)) readHeuristics(text);
    if (const char *text = dxEnvironment(dxVariable::GridCells)) readGridCells(text);
    if (const char *text = dxEnvironment(dxVariable::Workers)) readRemoteWorkers(text);
    dxLog(dxLogLevel::Info, "threads %u of %u cores, algorithm %s, solver %s, callbacks %s, heuristics %s", threads(), cores(),
          algorithmName(), nameOfSolver(solver().solver), callbackPolicyName(), dxNamesOfHeuristics(heuristics()));
}

void dxSettings::readThreads(const char *text) {
    if (std::strcmp(text, "auto") == 0) {
        setThreads(resolveThreads(dODE_MT_AUTO));
        return;
    }
    long long number = 0;
    const bool understood = dxReadNumber(text, 0, dODE_MT_MAX_THREADS, number) == dxNumberText::InRange;
    const int taken = static_cast<int>(number);
    if (!understood) {
        dxLog(dxLogLevel::Warning,
              "ODE_MT_THREADS is '%.100s'; known: auto, or a number from 0 to %d; %d is taken", text,
              dODE_MT_MAX_THREADS, taken);
    }
    setThreads(resolveThreads(taken));
}

void dxSettings::readAlgorithm(const char *text) {
    if (chooseAlgorithm(text)) return;
    dxLog(dxLogLevel::Warning, "ODE_MT_ALGORITHM is '%.100s'; known: %s; %s is taken", text,
          knownNames(kAlgorithms).c_str(), algorithmName());
}

void dxSettings::readSolver(const char *text) {
    if (const Named<dxSolver> *const known = find(kSolvers, text)) {
        m_solver.solver = known->choice;
        return;
    }
    dxLog(dxLogLevel::Warning, "ODE_MT_SOLVER is '%.100s'; known: %s; %s is taken", text, knownNames(kSolvers).c_str(),
          nameOfSolver(solver().solver));
}

void dxSettings::readTolerance(const char *text) {
    double tolerance = 0;
    if (dxReadReal(text, tolerance) && dxSolverChoice::isTolerance(tolerance)) {
        m_solver.tolerance = tolerance;
        return;
    }
    dxLog(dxLogLevel::Warning, "ODE_MT_SOLVER_TOLERANCE is '%.100s'; known: a number from 0 to 1; %g is taken", text, m_solver.tolerance);
}

void dxSettings::readWarmStart(const char *text) {
    long long number = m_solver.isWarm ? 1 : 0;
    const dxNumberText found = dxReadNumber(text, 0, 1, number);
    m_solver.isWarm = number != 0;
    if (found == dxNumberText::InRange) return;
    dxLog(dxLogLevel::Warning, "ODE_MT_WARM_START is '%.100s'; known: 0, 1; %d is taken", text, m_solver.isWarm ? 1 : 0);
}

const char *dxSettings::nameOfSolver(dxSolver solver) { return nameOf(kSolvers, solver); }

bool dxSettings::readSolver(const std::string &name, dxSolver &solver) {
    if (const Named<dxSolver> *const known = find(kSolvers, name)) {
        solver = known->choice;
        return true;
    }
    dMessage(0, "ODE_MT: no solver '%s'; known: %s", name.c_str(), knownNames(kSolvers).c_str());
    return false;
}

void dxSettings::readCallbackPolicy(const char *text) {
    if (chooseCallbackPolicy(text)) return;
    dxLog(dxLogLevel::Warning, "ODE_MT_CALLBACKS is '%.100s'; known: %s; %s is taken", text,
          knownNames(kCallbackPolicies).c_str(), callbackPolicyName());
}

const char *dxSettings::callbackPolicyName() const { return nameOf(kCallbackPolicies, callbackPolicy()); }

bool dxSettings::setCallbackPolicy(const std::string &name) {
    const bool found = chooseCallbackPolicy(name);
    if (!found)
        dMessage(0, "ODE_MT: no callback policy '%s'; known: %s", name.c_str(),
                 knownNames(kCallbackPolicies).c_str());
    return found;
}

bool dxSettings::chooseCallbackPolicy(const std::string &name) {
    return choose(kCallbackPolicies, name, m_callbackPolicy);
}

void dxSettings::readHeuristics(const char *text) {
    if (chooseHeuristics(text)) return;
    dxLog(dxLogLevel::Warning, "ODE_MT_HEURISTICS is '%.100s'; known: %s; %s is taken", text, knownHeuristics(),
          dxNamesOfHeuristics(heuristics()));
}

bool dxSettings::setHeuristics(const std::string &names) {
    const bool found = chooseHeuristics(names);
    if (!found) dMessage(0, "ODE_MT: no heuristics '%s'; known: %s", names.c_str(), knownHeuristics());
    return found;
}

bool dxSettings::chooseHeuristics(const std::string &names) {
    unsigned choice = dxNoHeuristics;
    if (!parseHeuristics(names, choice)) return false;
    m_heuristics.store(choice, std::memory_order_relaxed);
    return true;
}

void dxSettings::readGridCells(const char *text) {
    if (std::strcmp(text, "auto") == 0) return;
    long long number = kTunedCells;
    const bool understood = dxReadNumber(text, kMinGridCells, kMaxGridCells, number) == dxNumberText::InRange;
    chooseGridCells(static_cast<int>(number));
    if (understood) return;
    dxLog(dxLogLevel::Warning,
          "ODE_MT_GRID_CELLS is '%.100s'; known: auto, or a number from %d to %d; %s is taken", text,
          kMinGridCells, kMaxGridCells, number == kTunedCells ? "auto" : std::to_string(number).c_str());
}

// The library of the transport "loopback" is not installed: its workers are threads of the process, for tests.
void dxSettings::readRemoteWorkers(const char *text) {
    if (std::strcmp(text, "none") == 0) return;
    for (const char *const transport : {"mpi", "loopback"}) {
        const std::size_t length = std::strlen(transport);
        if (std::strncmp(text, transport, length) != 0) continue;
        long long wanted = 0;
        const bool isNumbered =
            text[length] == ':' && dxReadNumber(text + length + 1, 1, dxRemoteChoice::kMaxWorkers, wanted) == dxNumberText::InRange;
        if (text[length] != '\0' && !isNumbered) continue;
        m_remoteWorkers = {transport, static_cast<unsigned>(wanted)};
        return;
    }
    dxLog(dxLogLevel::Warning, "ODE_MT_WORKERS is '%.100s'; known: none, mpi, mpi:n with a number from 1 to %u; none is taken", text,
          dxRemoteChoice::kMaxWorkers);
}

bool dxSettings::setGridCells(int cells) {
    const bool possible = chooseGridCells(cells);
    if (!possible)
        dMessage(0, "ODE_MT: no grid of %d cells on each axis; known: %d to %d, or %d to have it tuned",
                 cells, kMinGridCells, kMaxGridCells, kTunedCells);
    return possible;
}

bool dxSettings::chooseGridCells(int cells) {
    if (cells != kTunedCells && (cells < kMinGridCells || cells > kMaxGridCells)) return false;
    m_gridCells.store(cells, std::memory_order_relaxed);
    return true;
}

unsigned dxSettings::resolveThreads(int threads) {
    m_cores.store(dxCountProcessors(), std::memory_order_relaxed);
    if (threads == dODE_MT_AUTO) {
        threads = static_cast<int>(cores());
    } else if (threads < 0) {
        dMessage(0, "ODE_MT: %d threads asked for; the least is 0 (serial), which is taken", threads);
        threads = 0;
    }
    if (threads > dODE_MT_MAX_THREADS) {
        dMessage(0, "ODE_MT: %d threads asked for; the most is %d, which is taken", threads,
                 dODE_MT_MAX_THREADS);
        threads = dODE_MT_MAX_THREADS;
    }
    return static_cast<unsigned>(threads);
}

void dxSettings::setThreads(unsigned threads) {
    const unsigned before = m_threads.exchange(threads, std::memory_order_relaxed);
    if (threads != before) dxLog(dxLogLevel::Info, "%u threads, %u before; %u cores", threads, before, cores());
}

const char *dxSettings::algorithmName() const { return nameOf(kAlgorithms, algorithm()); }

const char *dxSettings::passName() const {
    return algorithm() >= dxAlgorithm::ClusteredOriginal ? algorithmName() : nullptr;
}

bool dxSettings::setAlgorithm(const std::string &name) {
    const bool found = chooseAlgorithm(name);
    if (!found)
        dMessage(0, "ODE_MT: no algorithm '%s'; known: %s", name.c_str(), knownNames(kAlgorithms).c_str());
    return found;
}

bool dxSettings::chooseAlgorithm(const std::string &name) { return choose(kAlgorithms, name, m_algorithm); }

const char *dxNamesOfHeuristics(unsigned choice) { return heuristicTexts->of[choice]; }
