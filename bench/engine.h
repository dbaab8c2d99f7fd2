// The engines that the bench compares, by the names that a user gives them.
//
//   stock           the system's libode, one thread
//   stock:PATH      another libode.so.8, one thread: a file of any name, or a folder that has one
//   stock-pool:N    the system's libode with its own pool of N threads
//   ours:N          ODE_MT with N threads (0: serial; auto: one for every core)
//   ours:N/WORD     … with the thread manager pthread or openmp, with near-callbacks on several threads
//                   (concurrent), with a grid of that many cells on each axis (cells=8), or with the
//                   algorithm WORD, or with the direct solver behind dWorldStep (fast).
//                   Several words may follow one another: ours:2/decluster/concurrent/cells=8
#pragma once

#include <map>
#include <string>
#include <vector>

namespace bench {

struct Engine {
    enum class Kind { Stock, StockPool, Ours };

    Kind kind = Kind::Stock;
    std::string path;       // of another libode than the system's, or of its folder; empty: the system's, or ours
    std::string threads;    // "2", "auto"; empty for stock
    std::string manager;    // of ours; empty: the library's default
    std::string algorithm;  // of ours; empty: the library's default
    std::string solver;     // of ours; empty: the library's default
    std::string callbacks;  // of ours; empty: the library's default
    std::string gridCells;  // of ours; empty: the library's default

    // As it is written on the command line; control characters of a path are shown as such.
    std::string name() const;
    bool isOurs() const { return kind == Kind::Ours; }

    // Upstream's pool lets threads decide the order of additions: other bits in every run.
    bool isReproducible() const { return kind != Kind::StockPool; }

    // Those of the direct solver are its own.
    bool hasUpstreamsBits() const { return isReproducible() && solver != "fast"; }

    // What the environment of its process says.
    std::map<std::string, std::string> environment() const;
};

// Throws std::invalid_argument, naming the word that is wrong and the engines that exist.
Engine readEngine(const std::string &name);

// Reads a list as on the command line. "ours" without a number stands for one engine for each of
// `threads`, "stock-pool" without a number for a pool of the largest of them. `manager`, if not
// empty, is that of all of ours that name none.
std::vector<Engine> readEngines(const std::vector<std::string> &names,
                                const std::vector<std::string> &threads, const std::string &manager);

}  // namespace bench
