// How time grows with the size of a world: the results of worlds that differ in nothing but :N.
#pragma once

#include "summary.h"

#include <optional>
#include <string>
#include <vector>

namespace bench {

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

}  // namespace bench
