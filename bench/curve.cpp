#include "curve.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "world_source.h"

namespace bench {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

struct NameAndSize {
    std::string name;  // "pile:N,sap" of "pile:1000,sap"
    long size;
};

std::optional<NameAndSize> nameAndSize(const std::string &world) {
    const WorldSpec spec = readWorldSpec(world);
    NameAndSize result{spec.name + ":N", 0};
    std::from_chars(spec.size.data(), spec.size.data() + spec.size.size(), result.size);
    if (result.size < 1) return std::nullopt;
    for (const std::string &modifier : spec.modifiers) result.name += "," + modifier;
    return result;
}

template <class Curves>
auto findCurve(Curves &curves, const std::string &name) {
    return std::find_if(curves.begin(), curves.end(),
                        [&](const Curve &curve) { return curve.world == name; });
}

// Adds a point. If a world was measured twice, the first result counts.
void addPoint(Curve &curve, long size, const WorldResult &result) {
    const auto place =
        std::lower_bound(curve.points.begin(), curve.points.end(), size,
                         [](const CurvePoint &point, long other) { return point.size < other; });
    if (place == curve.points.end() || place->size != size)
        curve.points.insert(place, {size, summarize(result)});
}

}  // namespace

double Curve::seconds(Part part, std::size_t point, std::size_t engine) const {
    const EngineSummary &summary = points[point].engines[engine];
    return summary.failure.empty() ? summary.part(part).seconds.mean : kUnknown;
}

double Curve::growth(Part part, std::size_t point, std::size_t engine) const {
    if (point == 0) return kUnknown;
    const double times = seconds(part, point, engine) / seconds(part, point - 1, engine);
    const double sizes =
        static_cast<double>(points[point].size) / static_cast<double>(points[point - 1].size);
    return std::log(times) / std::log(sizes);
}

std::vector<Curve> curvesOf(const std::vector<WorldResult> &results) {
    std::vector<Curve> curves;
    for (const WorldResult &result : results) {
        const std::optional<NameAndSize> world = nameAndSize(result.world);
        if (!world) continue;
        auto curve = findCurve(curves, world->name);
        if (curve == curves.end()) curve = curves.insert(curve, {world->name, {}});
        addPoint(*curve, world->size, result);
    }
    curves.erase(std::remove_if(curves.begin(), curves.end(),
                                [](const Curve &curve) { return curve.points.size() < 2; }),
                 curves.end());
    return curves;
}

std::optional<CurvePlace> findInCurves(const std::vector<Curve> &curves, const std::string &world) {
    const std::optional<NameAndSize> wanted = nameAndSize(world);
    if (!wanted) return std::nullopt;
    const auto curve = findCurve(curves, wanted->name);
    if (curve == curves.end()) return std::nullopt;
    const auto point = std::find_if(curve->points.begin(), curve->points.end(),
                                    [&](const CurvePoint &point) { return point.size == wanted->size; });
    if (point == curve->points.end()) return std::nullopt;
    return CurvePlace{&*curve, static_cast<std::size_t>(point - curve->points.begin())};
}

namespace {

std::optional<unsigned> threadsOf(const Engine &engine) {
    unsigned threads = 0;
    const char *const end = engine.threads.data() + engine.threads.size();
    const auto [stop, error] = std::from_chars(engine.threads.data(), end, threads);
    if (!engine.isOurs() || error != std::errc() || stop != end) return std::nullopt;
    return threads;
}

std::string nameWithoutThreads(Engine engine) {
    engine.threads = "N";
    return engine.name();
}

// Adds a point. If an engine is named twice, the first counts.
void addPoint(Scaling &scaling, Scaling::Point point) {
    const auto isFewer = [](const Scaling::Point &other, unsigned threads) { return other.threads < threads; };
    const auto place = std::lower_bound(scaling.points.begin(), scaling.points.end(), point.threads, isFewer);
    if (place == scaling.points.end() || place->threads != point.threads) scaling.points.insert(place, point);
}

}  // namespace

std::vector<Scaling> scalingsOf(const std::vector<Engine> &engines) {
    std::vector<Scaling> scalings;
    for (std::size_t i = 0; i < engines.size(); ++i) {
        const std::optional<unsigned> threads = threadsOf(engines[i]);
        if (!threads) continue;
        const std::string name = nameWithoutThreads(engines[i]);
        auto scaling = std::find_if(scalings.begin(), scalings.end(),
                                    [&](const Scaling &other) { return other.engine == name; });
        if (scaling == scalings.end()) scaling = scalings.insert(scaling, {name, {}});
        addPoint(*scaling, {*threads, i});
    }
    scalings.erase(std::remove_if(scalings.begin(), scalings.end(),
                                  [](const Scaling &scaling) { return scaling.points.size() < 2; }),
                   scalings.end());
    return scalings;
}

}  // namespace bench
