// A callback that notes which alert came in which frame.
#pragma once

#include <cstdint>
#include <vector>

#include "heuristics/dxHeuristic.h"

template <class T>
struct AlertLog : HeuristicAlertCallback<T> {
    void alertCallback(dxHeuristic<T> &heuristic, const dxHeuristicAlert &) override {
        frames.push_back(heuristic.samples());
    }

    std::vector<std::uint64_t> frames;
};

// Hands in one value a frame.
template <class T>
void run(dxHeuristic<T> &heuristic, const std::vector<T> &values) {
    for (const T value : values) {
        heuristic.setValue(value);
        heuristic.tick();
    }
}
