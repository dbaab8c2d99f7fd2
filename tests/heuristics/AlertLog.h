// The numbers that a heuristic has set its parameter to.
#pragma once

#include <vector>

#include "clusters/heuristics/dxHeuristic.h"

struct AlertLog final : HeuristicAlertCallback {
    void alertCallback(const dxHeuristic &, const dxHeuristicAlert &alert) override { numbers.push_back(alert.now); }

    std::vector<double> numbers;
};
