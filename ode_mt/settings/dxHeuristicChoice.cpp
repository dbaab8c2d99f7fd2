#include "settings/dxHeuristicChoice.h"

#include <cstddef>
#include <cstring>
#include <sstream>

#include "threading/process/dxProcessObject.h"

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

// The names of each set, made once. They lie in the object itself: what it allocated would be lost with each unloading.
struct Texts {
    static constexpr std::size_t kMaxLength = 48;
    static_assert(sizeof "cells,centre,crossover,declustering,threads" <= kMaxLength, "all of kNames");

    char of[1u << kCount][kMaxLength] = {"none"};

    Texts() {
        for (unsigned choice = 1; choice < 1u << kCount; ++choice)
            for (unsigned bit = 0; bit < kCount; ++bit)
                if ((choice >> bit & 1u) != 0) append(of[choice], kNames[bit]);
    }

    static void append(char *text, const char *name) {
        if (*text != '\0') std::strcat(text, ",");
        std::strcat(text, name);
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

const char *dxNamesOfHeuristics(unsigned choice) { return texts->of[choice]; }

const char *dxKnownHeuristics() { return "default, none, cells, centre, crossover, declustering, threads"; }
