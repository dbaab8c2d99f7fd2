#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "curve.h"
#include "summary.h"
#include "report.h"
#include "support/text.h"

namespace bench {

namespace {

void writeHeader(std::ostream &out, const std::vector<Part> &parts, bool withCurves) {
    out << "world,engine,bodies,frames,rounds";
    for (Part part : parts)
        for (const char *figure :
             {"_mean_s", "_deviation_s", "_speedup_median", "_speedup_q1", "_speedup_q3"})
            out << ',' << nameOf(part) << figure;
    out << ",real_time_factor,shared_steps,hash,state,failure";
    if (withCurves) {
        out << ",size";
        for (Part part : Curve::kReported) out << ',' << nameOf(part) << "_growth";
    }
    out << '\n';
}

void writeLine(std::ostream &out, const WorldResult &result, const EngineResult &engine,
               const EngineSummary &summary, const std::vector<Part> &parts) {
    out << support::csvField(result.world) << ',' << support::csvField(summary.engine) << ',' << engine.ready.bodies << ','
        << result.frames << ',' << engine.batches.size();
    for (Part part : parts) {
        const PartSummary &figures = summary.part(part);
        out << ',' << figures.seconds.mean << ',' << figures.seconds.deviation << ','
            << figures.speedUp.median << ',' << figures.speedUp.lowerQuartile << ','
            << figures.speedUp.upperQuartile;
    }
    out << ',' << summary.realTimeFactor << ',' << summary.sharedSteps << ',' << hashText(summary.hash) << ','
        << nameOf(summary.check) << ',' << support::csvField(summary.failure);
}

// Empty fields for what has no curve or no smaller size.
void writeGrowth(std::ostream &out, const std::vector<Curve> &curves, const std::string &world,
                 std::size_t engine) {
    const std::optional<CurvePlace> place = findInCurves(curves, world);
    out << ',';
    if (place) out << place->curve->points[place->point].size;
    for (Part part : Curve::kReported) {
        out << ',';
        const double growth = place ? place->curve->growth(part, place->point, engine) : NAN;
        if (std::isfinite(growth)) out << growth;
    }
}

}  // namespace

std::string reportCsv(const std::vector<WorldResult> &results) {
    std::ostringstream out;
    out << std::setprecision(9);
    const bool callbacksTimed = std::any_of(
        results.begin(), results.end(), [](const WorldResult &result) { return result.callbacksTimed(); });
    const std::vector<Part> parts = partsToReport(callbacksTimed);
    const std::vector<Curve> curves = curvesOf(results);
    writeHeader(out, parts, !curves.empty());
    for (const WorldResult &result : results) {
        const std::vector<EngineSummary> summaries = summarize(result);
        for (std::size_t i = 0; i < summaries.size(); ++i) {
            writeLine(out, result, result.engines[i], summaries[i], parts);
            if (!curves.empty()) writeGrowth(out, curves, result.world, i);
            out << '\n';
        }
    }
    return out.str();
}

std::string reportSamples(const std::vector<WorldResult> &results) {
    std::ostringstream out;
    out << std::setprecision(6) << "world,engine,second,real_time_factor\n";
    for (const WorldResult &result : results) {
        for (const EngineResult &engine : result.engines) {
            int second = 0;
            for (double factor : realTimeSamples(engine))
                out << support::csvField(result.world) << ',' << support::csvField(engine.engine.name()) << ',' << ++second
                    << ',' << factor << '\n';
        }
    }
    return out.str();
}

}  // namespace bench
