// Owns the heuristics of one (world, space) pair (thesis, figure A.5).
//
// tick() is called once at the end of every search for pairs and ticks the heuristics in the order in which they were added, so
// that alerts come in the same order in every run. Unlike the thesis's manager this one knows no heuristic, world or cluster: its
// owner (dxClusterBroadphase) decides what is observed and acts upon it. There is no global state; several pairs have several managers.
//
// Threading: none, owned and used by the thread that runs the pair's frame.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "clusters/heuristics/dxHeuristic.h"

class dxHeuristicsManager {
public:
    template <class Heuristic>
    Heuristic *add(std::unique_ptr<Heuristic> heuristic) {
        Heuristic *const typed = heuristic.get();
        m_heuristics.push_back(std::move(heuristic));
        return typed;
    }

    void tick() {
        for (const std::unique_ptr<dxHeuristic> &heuristic : m_heuristics) heuristic->tick();
    }

private:
    std::vector<std::unique_ptr<dxHeuristic>> m_heuristics;
};
