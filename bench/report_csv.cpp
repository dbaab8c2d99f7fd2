#include "csv_field.h"
#include "report.h"
#include "summary.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace bench {

namespace {

void writeHeader(std::ostream &out, const std::vector<Part> &parts) {
    out << "world,engine,bodies,frames,rounds";
    for (Part part : parts)
        for (const char *figure :
             {"_mean_s", "_deviation_s", "_speedup_median", "_speedup_q1", "_speedup_q3"})
            out << ',' << nameOf(part) << figure;
    out << ",real_time_factor,shared_steps,hash,state,failure\n";
}

void writeLine(std::ostream &out, const WorldResult &result, const EngineResult &engine,
               const EngineSummary &summary, const std::vector<Part> &parts) {
    out << csvField(result.world) << ',' << csvField(summary.engine) << ',' << engine.ready.bodies << ','
        << result.frames << ',' << engine.batches.size();
    for (Part part : parts) {
        const PartSummary &figures = summary.part(part);
        out << ',' << figures.seconds.mean << ',' << figures.seconds.deviation << ','
            << figures.speedUp.median << ',' << figures.speedUp.lowerQuartile << ','
            << figures.speedUp.upperQuartile;
    }
    out << ',' << summary.realTimeFactor << ',' << summary.sharedSteps << ',' << hashText(summary.hash) << ','
        << nameOf(summary.check) << ',' << csvField(summary.failure) << '\n';
}

}  // namespace

std::string reportCsv(const std::vector<WorldResult> &results) {
    std::ostringstream out;
    out << std::setprecision(9);
    const bool callbacksTimed = std::any_of(
        results.begin(), results.end(), [](const WorldResult &result) { return result.callbacksTimed(); });
    const std::vector<Part> parts = partsToReport(callbacksTimed);
    writeHeader(out, parts);
    for (const WorldResult &result : results) {
        const std::vector<EngineSummary> summaries = summarize(result);
        for (std::size_t i = 0; i < summaries.size(); ++i)
            writeLine(out, result, result.engines[i], summaries[i], parts);
    }
    return out.str();
}

}  // namespace bench
