#include "number_text.h"
#include "report.h"
#include "scaling.h"
#include "summary.h"
#include "table.h"

namespace bench {

namespace {

constexpr Part kReported[] = {Part::Frame, Part::Collision, Part::Dynamics};

std::vector<Engine> enginesOf(const WorldResult &result) {
    std::vector<Engine> engines;
    for (const EngineResult &engine : result.engines) engines.push_back(engine.engine);
    return engines;
}

std::vector<Table::Column> columns(const Scaling &scaling) {
    std::vector<Table::Column> columns = {{"world", Table::Align::Left}};
    for (Part part : kReported)
        for (const Scaling::Point &point : scaling.points) {
            const std::string threads = std::to_string(point.threads);
            columns.push_back({&point == scaling.points.data() ? nameOf(part) + (": " + threads) : threads});
        }
    return columns;
}

std::vector<std::string> cells(const Scaling &scaling, const WorldResult &result) {
    const std::vector<EngineSummary> summaries = summarize(result);
    std::vector<std::string> cells = {result.world};
    for (Part part : kReported)
        for (const Scaling::Point &point : scaling.points) {
            const EngineSummary &summary = summaries[point.engine];
            cells.push_back(summary.failure.empty() ? numberText(summary.part(part).speedUp.median) : "-");
        }
    return cells;
}

}  // namespace

// All worlds of a run have the same engines.
std::string reportScaling(const std::vector<WorldResult> &results) {
    std::string text;
    if (results.empty()) return text;
    const std::vector<Engine> engines = enginesOf(results.front());
    for (const Scaling &scaling : scalingsOf(engines)) {
        Table table(columns(scaling));
        for (const WorldResult &result : results) table.addRow(cells(scaling, result));
        text += "== " + scaling.engine + ": speed-up over " + engines.front().name() + ", by threads ==\n\n" +
                table.text() + "\n";
    }
    return text;
}

}  // namespace bench
