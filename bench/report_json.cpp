#include "curve.h"
#include "platform.h"
#include "summary.h"
#include "report.h"
#include "support/statistics.h"

#include <nlohmann/json.hpp>

namespace bench {

using nlohmann::json;

namespace {

json toJson(const support::Spread &s) {
    return {{"median", s.median},
            {"lowerQuartile", s.lowerQuartile},
            {"upperQuartile", s.upperQuartile},
            {"percentile5", s.percentile5},
            {"percentile95", s.percentile95}};
}

json toJson(const Machine &machine) { return {{"processor", machine.processor}, {"cores", machine.cores}}; }

json samplesToJson(const std::vector<double> &samples) {
    const support::MeanAndDeviation summary = support::meanAndDeviation(samples);
    return {{"count", samples.size()},
            {"mean", summary.mean},
            {"deviation", summary.deviation},
            {"quantiles", toJson(support::spreadOf(samples))}};
}

// Bins that hold frames, by rising time.
json frameTimesToJson(const EngineResult &engine) {
    FrameTimes times;
    for (const Batch &batch : engine.batches) times += batch.frameTimes;
    json seconds = json::array(), frames = json::array();
    for (const auto &[bin, count] : times.counts()) {
        seconds.push_back(FrameTimes::lowerBound(bin));
        frames.push_back(count);
    }
    return {{"binsPerDoubling", FrameTimes::kBinsPerDoubling}, {"seconds", seconds}, {"frames", frames}};
}

json toJson(const EngineResult &engine, const EngineSummary &summary, bool withAverages) {
    json parts;
    for (Part part : partsToReport(engine.callbacksTimed())) {
        const PartSummary &figures = summary.part(part);
        parts[nameOf(part)] = {{"meanSeconds", figures.seconds.mean},
                               {"deviationSeconds", figures.seconds.deviation},
                               {"speedUp", toJson(figures.speedUp)}};
        if (withAverages) parts[nameOf(part)]["keptAverages"] = engine.average(part).kept();
    }
    return {{"engine", summary.engine},
            {"library", engine.ready.library},
            {"release", engine.ready.release},
            {"threads", engine.ready.threads},
            {"threadManager", engine.ready.manager},
            {"algorithm", engine.ready.algorithm},
            {"callbacks", engine.ready.callbacks},
            {"gridCells", engine.ready.gridCells},
            {"parts", parts},
            {"frameTimes", frameTimesToJson(engine)},
            {"realTimeFactor", summary.realTimeFactor},
            {"realTimeSamples", samplesToJson(realTimeSamples(engine))},
            {"sharedSteps", summary.sharedSteps},
            {"serialShare", summary.work.isKnown() ? json(summary.work.share()) : json()},
            {"odeMessages", summary.messages},
            {"hash", hashText(summary.hash)},
            {"state", nameOf(summary.check)},
            {"firstDifference", engine.firstDifference},
            {"failure", summary.failure}};
}

json toJson(const WorldResult &result, bool withAverages) {
    json engines = json::array();
    const std::vector<EngineSummary> summaries = summarize(result);
    for (std::size_t i = 0; i < summaries.size(); ++i)
        engines.push_back(toJson(result.engines[i], summaries[i], withAverages));
    const Ready &ready = result.engines.front().ready;
    return {{"world", result.world},
            {"bodies", ready.bodies},
            {"joints", ready.joints},
            {"geoms", ready.geoms},
            {"stepSize", ready.stepSize},
            {"warnings", ready.warnings},
            {"warmUpFrames", result.warmUpFrames},
            {"frames", result.frames},
            {"rounds", result.rounds},
            {"ended", toString(result.verdict)},
            {"engines", engines}};
}

json toJson(const Curve &curve, std::size_t engine) {
    json entry = {{"engine", curve.points[0].engines[engine].engine}};
    for (Part part : Curve::kReported) {
        json seconds = json::array(), growth = json::array();
        for (std::size_t point = 0; point < curve.points.size(); ++point) {
            seconds.push_back(curve.seconds(part, point, engine));
            growth.push_back(curve.growth(part, point, engine));
        }
        entry["parts"][nameOf(part)] = {{"meanSeconds", seconds}, {"growth", growth}};
    }
    return entry;
}

json toJson(const Curve &curve) {
    json sizes = json::array(), engines = json::array();
    for (const CurvePoint &point : curve.points) sizes.push_back(point.size);
    for (std::size_t engine = 0; engine < curve.points[0].engines.size(); ++engine)
        engines.push_back(toJson(curve, engine));
    return {{"world", curve.world}, {"sizes", sizes}, {"engines", engines}};
}

}  // namespace

std::string reportJson(const std::vector<WorldResult> &results, bool withAverages) {
    json worlds = json::array(), curves = json::array();
    for (const WorldResult &result : results) worlds.push_back(toJson(result, withAverages));
    for (const Curve &curve : curvesOf(results)) curves.push_back(toJson(curve));
    return json{{"machine", toJson(thisMachine())}, {"worlds", worlds}, {"curves", curves}}.dump(
               1, ' ', false, json::error_handler_t::replace) +
           "\n";
}

}  // namespace bench
