#include "scaling.h"

#include <algorithm>
#include <charconv>
#include <optional>

namespace bench {

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
