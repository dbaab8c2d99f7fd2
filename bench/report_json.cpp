#include "report.h"
#include "summary.h"

#include <nlohmann/json.hpp>

namespace bench {

using nlohmann::json;

namespace {

json toJson(const Spread &s) {
    return {{"median", s.median},
            {"lowerQuartile", s.lowerQuartile},
            {"upperQuartile", s.upperQuartile},
            {"percentile5", s.percentile5},
            {"percentile95", s.percentile95}};
}

json toJson(const EngineResult &engine, const EngineSummary &summary) {
    json parts;
    for (Part part : kParts) {
        const PartSummary &figures = summary.part(part);
        parts[nameOf(part)] = {{"meanSeconds", figures.seconds.mean},
                               {"deviationSeconds", figures.seconds.deviation},
                               {"keptAverages", engine.average(part).kept()},
                               {"speedUp", toJson(figures.speedUp)}};
    }
    return {{"engine", summary.engine},
            {"library", engine.ready.library},
            {"threads", engine.ready.threads},
            {"threadManager", engine.ready.manager},
            {"algorithm", engine.ready.algorithm},
            {"parts", parts},
            {"realTimeFactor", summary.realTimeFactor},
            {"sharedSteps", summary.sharedSteps},
            {"odeMessages", summary.messages},
            {"hash", hashText(summary.hash)},
            {"state", nameOf(summary.check)},
            {"firstDifference", engine.firstDifference},
            {"failure", summary.failure}};
}

json toJson(const WorldResult &result) {
    json engines = json::array();
    const std::vector<EngineSummary> summaries = summarize(result);
    for (std::size_t i = 0; i < summaries.size(); ++i)
        engines.push_back(toJson(result.engines[i], summaries[i]));
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

}  // namespace

std::string reportJson(const std::vector<WorldResult> &results) {
    json worlds = json::array();
    for (const WorldResult &result : results) worlds.push_back(toJson(result));
    return json{{"worlds", worlds}}.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

}  // namespace bench
