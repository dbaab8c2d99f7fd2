// Which heuristics run: a set of them, and their names as the user writes them (dODE_MT_SetHeuristics).
#pragma once

#include <string>

enum dxHeuristicChoice : unsigned {
    dxTuneCells = 1u << 0,
    dxTuneCentre = 1u << 1,
    dxSkipCrossovers = 1u << 2,
    dxSkipDeclustering = 1u << 3,
    dxTuneThreads = 1u << 4,

    dxNoHeuristics = 0,
    dxDefaultHeuristics = dxTuneCells | dxTuneCentre | dxSkipCrossovers | dxSkipDeclustering
};

// "default", "none", or names with commas between them. False: one is unknown, and `choice` is as it was.
bool dxReadHeuristics(const std::string &names, unsigned &choice);

// "none", or names with commas between them. For ever.
const char *dxNamesOfHeuristics(unsigned choice);

// All that dxReadHeuristics knows.
const char *dxKnownHeuristics();
