// How figures of several results depend on one quantity: time on the size of a world, speed-up on the number of threads.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine.h"
#include "summary.h"

namespace bench {

// How time grows with the size of a world: the results of worlds that differ in nothing but :N.
struct CurvePoint {
    long size;
    std::vector<EngineSummary> engines;
};

struct Curve {
    static constexpr Part kReported[] = {Part::Collision, Part::Frame};

    std::string world;               // "pile:N,sap"
    std::vector<CurvePoint> points;  // two or more, by rising size, with the same engines

    // Mean of a frame; NaN if the engine failed.
    double seconds(Part part, std::size_t point, std::size_t engine) const;

    // The power of the size that time has grown with since the point before: 1 is linear, 2 quadratic. For a
    // size that has doubled log2(t(2N) / t(N)). NaN at the first point and where a time is not known.
    double growth(Part part, std::size_t point, std::size_t engine) const;
};

// Returns the curves in the order of their worlds. A world without a size belongs to no curve.
std::vector<Curve> curvesOf(const std::vector<WorldResult> &results);

struct CurvePlace {
    const Curve *curve;
    std::size_t point;
};
std::optional<CurvePlace> findInCurves(const std::vector<Curve> &curves, const std::string &world);

// How speed-up grows with the number of threads: engines of a run that differ in nothing else.
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
