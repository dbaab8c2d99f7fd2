// Functions that scripts call: ODE_MT's own. Debian's library has none of them and nothing to change; results must be the same.
#include "by_hand.h"

#include <dlfcn.h>

namespace fuzz {

namespace {

template <class Type>
void callIfThere(const char *name, Type argument) {
    if (void *const found = dlsym(RTLD_DEFAULT, name)) reinterpret_cast<void (*)(Type)>(found)(argument);
}

void addChoice(std::vector<Function> &all, const char *name, std::vector<std::string> words) {
    const std::string function = name;
    byHand(all, name, {word(std::move(words))}, [function](Player &, const Arguments &arguments, Reference &) {
        callIfThere(function.c_str(), arguments[0].word.c_str());
        return true;
    }, 2);
}

}  // namespace

void addSettingFunctions(std::vector<Function> &all) {
    byHand(all, "dToggleODE_MT", {number(Meaning::choice)}, [](Player &, const Arguments &arguments, Reference &) {
        callIfThere("dToggleODE_MT", whole(arguments[0]));
        return true;
    }, 3);
    byHand(all, "dODE_MT_SetGridCells", {number(Meaning::choice)}, [](Player &, const Arguments &arguments, Reference &) {
        const int cells = whole(arguments[0]);
        callIfThere("dODE_MT_SetGridCells", cells >= 1 && cells <= 7 ? 4 + 2 * cells : 0);
        return true;
    }, 2);
    addChoice(all, "dODE_MT_SetAlgorithm",
              {"auto", "lcp", "serial", "original", "static", "static-unmerged", "duplication", "decluster"});
    addChoice(all, "dODE_MT_SetHeuristics",
              {"default", "none", "cells", "centre", "crossover", "declustering", "threads", "cells,centre,crossover,declustering,threads"});
    addChoice(all, "dODE_MT_SetThreadManager", {"pthread", "openmp"});
    // The player then does what such callbacks may do, on both libraries.
    byHand(all, "dODE_MT_SetCallbackPolicy", {word({"serial", "concurrent", "independent"})},
           [](Player &player, const Arguments &arguments, Reference &) {
               callIfThere("dODE_MT_SetCallbackPolicy", arguments[0].word.c_str());
               player.setCallbackPolicy(arguments[0].word);
               return true;
           }, 2);
}

}  // namespace fuzz
