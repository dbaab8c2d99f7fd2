#include "frame/dxHeuristicChoice.h"

#include <array>
#include <sstream>

#include "threading/dxProcessObject.h"

namespace {

// By bit.
constexpr const char *kNames[] = {"cells", "centre", "crossover", "declustering", "threads"};
constexpr unsigned kCount = sizeof kNames / sizeof *kNames;

bool add(const std::string &name, unsigned &choice) {
    for (unsigned bit = 0; bit < kCount; ++bit) {
        if (name != kNames[bit]) continue;
        choice |= 1u << bit;
        return true;
    }
    return false;
}

// The names of each set, made once.
struct Texts {
    std::array<std::string, 1u << kCount> of;

    Texts() {
        of[dxNoHeuristics] = "none";
        for (unsigned choice = 1; choice < of.size(); ++choice)
            for (unsigned bit = 0; bit < kCount; ++bit)
                if ((choice >> bit & 1u) != 0) of[choice] += (of[choice].empty() ? "" : ",") + std::string(kNames[bit]);
    }
};

dxProcessObject<Texts> texts;

}  // namespace

bool dxReadHeuristics(const std::string &names, unsigned &choice) {
    if (names == "default" || names == "none") {
        choice = names == "default" ? dxDefaultHeuristics : dxNoHeuristics;
        return true;
    }
    if (names.empty() || names.back() == ',') return false;
    unsigned read = dxNoHeuristics;
    std::istringstream stream(names);
    for (std::string name; std::getline(stream, name, ',');)
        if (!add(name, read)) return false;
    choice = read;
    return true;
}

const char *dxNamesOfHeuristics(unsigned choice) { return texts->of[choice].c_str(); }

const char *dxKnownHeuristics() { return "default, none, cells, centre, crossover, declustering, threads"; }
