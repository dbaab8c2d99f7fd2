#include "engine.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "support/text.h"

namespace bench {

namespace {

constexpr int kMaxThreads = 1024;
constexpr int kMinCells = 5, kMaxCells = 20;
const std::string kCells = "cells=", kStockPath = "stock:";
// The names must be those of the library; it would use the default for any other, without a report where the child has no log.
const std::vector<std::string> kAlgorithms = {"auto",   "serial",          "lcp",         "original",
                                              "static", "static-unmerged", "duplication", "decluster"};

bool isManager(const std::string &word) { return word == "pthread" || word == "openmp"; }

// The number in `text`, or -1 if it is none or not from `lowest` to `highest`.
int readNumber(const std::string &text, int lowest, int highest) {
    int number = 0;
    const char *end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, number);
    const bool isNumber = error == std::errc() && stopped == end && text == std::to_string(number);
    return isNumber && number >= lowest && number <= highest ? number : -1;
}

int readThreads(const std::string &text, int lowest) { return readNumber(text, lowest, kMaxThreads); }

void checkCells(const std::string &engine, const std::string &cells) {
    if (readNumber(cells, kMinCells, kMaxCells) < 0)
        throw std::invalid_argument("engine '" + engine + "': '" + cells +
                                    "' is not a number of grid cells from " + std::to_string(kMinCells) +
                                    " to " + std::to_string(kMaxCells));
}

void checkThreads(const std::string &engine, const std::string &threads, int lowest, bool mayBeAuto) {
    if (mayBeAuto && threads == "auto") return;
    if (readThreads(threads, lowest) < 0)
        throw std::invalid_argument("engine '" + engine + "': '" + threads +
                                    "' is not a number of threads from " + std::to_string(lowest) + " to " +
                                    std::to_string(kMaxThreads) + (mayBeAuto ? ", nor 'auto'" : ""));
}

// Removes the part after the last `separator` from `text` and returns it; empty if there is none.
std::string takeSuffix(std::string &text, char separator) {
    const std::size_t at = text.find(separator);
    if (at == std::string::npos) return "";
    const std::string suffix = text.substr(at + 1);
    text.erase(at);
    return suffix;
}

std::string largest(const std::vector<std::string> &threads) {
    int most = 1;
    for (const std::string &text : threads) most = std::max(most, readThreads(text, 0));
    return std::to_string(most);
}

std::vector<std::string> expand(const std::string &name, const std::vector<std::string> &threads) {
    if (name == "stock-pool") return {name + ":" + largest(threads)};
    if (name != "ours") return {name};
    std::vector<std::string> names;
    for (const std::string &text : threads) names.push_back(name + ":" + text);
    return names;
}

void setOnce(const std::string &name, std::string &part, const std::string &word) {
    if (!part.empty())
        throw std::invalid_argument("engine '" + name + "': '" + part + "' and '" + word +
                                    "' exclude one another");
    part = word;
}

// One of the words behind the slashes of an engine of ours.
void readWord(const std::string &name, const std::string &word, Engine &engine) {
    if (isManager(word)) {
        setOnce(name, engine.manager, word);
    } else if (word == "concurrent" || word == "independent") {
        setOnce(name, engine.callbacks, word);
    } else if (word == "exact" || word == "fast") {
        setOnce(name, engine.solver, word);
    } else if (word.compare(0, kCells.size(), kCells) == 0) {
        checkCells(name, word.substr(kCells.size()));
        setOnce(name, engine.gridCells, word.substr(kCells.size()));
    } else if (std::find(kAlgorithms.begin(), kAlgorithms.end(), word) != kAlgorithms.end()) {
        setOnce(name, engine.algorithm, word);
    } else {
        std::string known = "pthread, openmp, exact, fast, concurrent, independent, cells=K";
        for (const std::string &algorithm : kAlgorithms) known += ", " + algorithm;
        throw std::invalid_argument("engine '" + name + "': unknown word '" + word + "'; known: " + known);
    }
}

std::string slash(const std::string &word) { return word.empty() ? "" : "/" + word; }

}  // namespace

std::string Engine::name() const {
    switch (kind) {
        case Kind::Stock:
            return path.empty() ? "stock" : kStockPath + support::printable(path);
        case Kind::StockPool:
            return "stock-pool:" + threads;
        case Kind::Ours:
            break;
    }
    return "ours:" + threads + slash(manager) + slash(algorithm) + slash(solver) + slash(callbacks) +
           slash(gridCells.empty() ? "" : kCells + gridCells);
}

std::map<std::string, std::string> Engine::environment() const {
    std::map<std::string, std::string> variables;
    if (!isOurs()) return variables;
    variables["ODE_MT_THREADS"] = threads;
    if (!manager.empty()) variables["ODE_MT_THREAD_MANAGER"] = manager;
    if (!algorithm.empty()) variables["ODE_MT_ALGORITHM"] = algorithm;
    if (!solver.empty()) variables["ODE_MT_SOLVER"] = solver;
    if (!callbacks.empty()) variables["ODE_MT_CALLBACKS"] = callbacks;
    if (!gridCells.empty()) variables["ODE_MT_GRID_CELLS"] = gridCells;
    return variables;
}

Engine readEngine(const std::string &name) {
    std::string rest = name;
    Engine engine;
    if (name.compare(0, kStockPath.size(), kStockPath) == 0) {
        engine.path = name.substr(kStockPath.size());
        if (engine.path.empty()) throw std::invalid_argument("engine '" + name + "': no path of a libode.so.8 behind the colon");
        return engine;
    }
    const bool hasWords = rest.find('/') != std::string::npos;
    std::string words = takeSuffix(rest, '/');
    for (bool more = hasWords; more;) {
        more = words.find('/') != std::string::npos;
        const std::string next = takeSuffix(words, '/');
        if (rest.compare(0, 4, "ours") == 0) readWord(name, words, engine);
        words = next;
    }
    const bool hasThreads = rest.find(':') != std::string::npos;
    engine.threads = takeSuffix(rest, ':');

    if (rest == "stock" && !hasThreads && !hasWords) return engine;
    if (rest == "stock-pool" && !hasWords) {
        engine.kind = Engine::Kind::StockPool;
        checkThreads(name, engine.threads, 1, false);
        return engine;
    }
    if (rest == "ours") {
        engine.kind = Engine::Kind::Ours;
        checkThreads(name, engine.threads, 0, true);
        return engine;
    }
    throw std::invalid_argument(
        "unknown engine '" + name +
        "'; known: stock, stock:PATH, stock-pool:N, ours:N, ours:auto, ours:N/pthread, ours:N/openmp, "
        "ours:N/exact, ours:N/fast, ours:N/concurrent, ours:N/independent, ours:N/cells=K, ours:N/ALGORITHM");
}

std::vector<Engine> readEngines(const std::vector<std::string> &names,
                                const std::vector<std::string> &threads, const std::string &manager) {
    if (!manager.empty() && !isManager(manager))
        throw std::invalid_argument("unknown thread manager '" + manager + "'; known: pthread, openmp");
    for (const std::string &count : threads) readEngine("ours:" + count);  // also where no engine takes its number from there
    std::vector<Engine> engines;
    for (const std::string &name : names) {
        for (const std::string &expanded : expand(name, threads)) {
            Engine engine = readEngine(expanded);
            if (engine.isOurs() && engine.manager.empty()) engine.manager = manager;
            const bool known = std::any_of(engines.begin(), engines.end(), [&](const Engine &other) {
                return other.name() == engine.name();
            });
            if (known) throw std::invalid_argument("engine '" + engine.name() + "' is listed twice");
            engines.push_back(engine);
        }
    }
    if (engines.empty()) throw std::invalid_argument("no engines to compare");
    return engines;
}

}  // namespace bench
