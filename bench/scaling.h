// How speed-up grows with the number of threads: engines of a run that differ in nothing else.
#pragma once

#include "engine.h"

#include <cstddef>
#include <string>
#include <vector>

namespace bench {

struct Scaling {
    struct Point {
        unsigned threads;
        std::size_t engine;  // its place in the run
    };

    std::string engine;         // "ours:N/independent"
    std::vector<Point> points;  // two or more, by rising number of threads
};

// Returns the curves in the order of their engines. Engines that are not ours, and "auto", have no number of threads.
std::vector<Scaling> scalingsOf(const std::vector<Engine> &engines);

}  // namespace bench
