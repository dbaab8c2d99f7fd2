// A world whose frames cost what a function of the number of grid cells says.
#pragma once

#include <cmath>
#include <functional>
#include <utility>

#include "clusters/heuristics/dxCellSizeHeuristic.h"

using CostOf = std::function<double(int cells)>;  // ns

// Runs frames whose cost and cluster count depend on the cells.
class CellWorld {
public:
    explicit CellWorld(CostOf cost, unsigned interval = dxCellSizeHeuristic::kDefaultInterval)
        : rule(interval), m_cost(std::move(cost)) {
        rule.start();
    }

    void frame() {
        rule.observe({m_cost(rule.cells()), clusters(rule.cells()), entities});
        rule.tick();
    }
    void frames(unsigned count) {
        for (unsigned i = 0; i < count; ++i) frame();
    }

    // Frames until the rule holds a number of cells.
    unsigned climb() {
        unsigned frames = 0;
        for (; rule.phase() == dxCellSizeHeuristic::Phase::Climb && frames < 100000; ++frames) frame();
        return frames;
    }

    void setCost(CostOf cost) { m_cost = std::move(cost); }

    dxCellSizeHeuristic rule;
    std::function<unsigned(int)> clusters = [](int) { return 1u; };
    unsigned entities = 0;

private:
    CostOf m_cost;
};

// Cheapest at `best`, more expensive by `slope` a cell to both sides.
inline CostOf valley(int best, double slope = 0.05) {
    return [=](int cells) { return 1e5 * (1 + slope * std::abs(cells - best)); };
}
