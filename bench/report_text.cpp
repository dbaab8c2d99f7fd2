#include "support/text.h"
#include "number_text.h"
#include "report.h"
#include "summary.h"
#include "table.h"
#include "support/statistics.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <utility>
#include <vector>

namespace bench {

namespace {

template <class... Values>
std::string format(const char *pattern, Values... values) {
    char text[160];
    std::snprintf(text, sizeof text, pattern, values...);
    return text;
}

std::string ratio(const support::Spread &spread) {
    if (!std::isfinite(spread.median)) return "-";
    if (spread.lowerQuartile == 1 && spread.upperQuartile == 1) return "1";  // the first engine itself
    return format("%.2f [%.2f, %.2f]", spread.median, spread.lowerQuartile, spread.upperQuartile);
}

std::string state(const EngineSummary &summary) {
    switch (summary.check) {
        case StateCheck::Differs:
            return hashText(summary.hash) + " DIFFERS";
        case StateCheck::NotReproducible:
            return hashText(summary.hash) + " not reproducible";
        case StateCheck::OwnBits:
            return hashText(summary.hash) + " own bits";
        case StateCheck::OtherRelease:
            return hashText(summary.hash) + " other release";
        case StateCheck::Unknown:
            return "-";
        default:
            return hashText(summary.hash);
    }
}

// One line for each release of ODE, with the engines that have it; those that did not start are not known to have one.
std::string releases(const WorldResult &result) {
    std::vector<std::pair<std::string, std::string>> lines;
    for (const EngineResult &engine : result.engines) {
        if (engine.ready.library.empty()) continue;
        const std::string &release = engine.ready.release;
        const auto line = std::find_if(lines.begin(), lines.end(), [&](const auto &known) { return known.first == release; });
        if (line == lines.end())
            lines.emplace_back(release, engine.engine.name());
        else
            line->second += ", " + engine.engine.name();
    }
    std::string text;
    for (const auto &[release, engines] : lines)
        text += (release == kUnknownRelease ? "a release of ODE that is not known: " : "ODE " + release + ": ") + engines + '\n';
    return text;
}

std::string title(const WorldResult &result) {
    std::string text = "== " + support::printable(result.world) + " ==\n";
    for (const EngineResult &engine : result.engines) {
        const Ready &r = engine.ready;
        if (r.stepSize == 0) continue;
        text +=
            format("%zu bodies, %zu joints, %zu geoms, step %g s; ", r.bodies, r.joints, r.geoms, r.stepSize);
        break;
    }
    text += format("%ld + %ld frames in %d rounds; ", result.warmUpFrames, result.frames, result.rounds);
    return text + toString(result.verdict) + "\n" + releases(result) + "\n";
}

std::vector<std::string> cells(const EngineSummary &summary, bool isOurs, bool callbacksTimed) {
    const PartSummary &frame = summary.part(Part::Frame);
    std::vector<std::string> cells = {
        summary.engine,
        millisecondsText(frame.seconds.mean) + " ± " + millisecondsText(frame.seconds.deviation),
        millisecondsText(summary.part(Part::Collision).seconds.mean),
        millisecondsText(summary.part(Part::Dynamics).seconds.mean),
        millisecondsText(summary.part(Part::Overhead).seconds.mean),
        ratio(frame.speedUp),
        ratio(summary.part(Part::Collision).speedUp),
        ratio(summary.part(Part::Dynamics).speedUp),
        ratio(summary.part(Part::Overhead).speedUp),
        numberText(summary.realTimeFactor),
        isOurs ? format("%.0f %%", 100 * summary.sharedSteps) : "",
        state(summary)};
    if (callbacksTimed) {
        const PartSummary &outside = summary.part(Part::OutsideCallbacks);
        cells.insert(cells.end() - 1, {millisecondsText(summary.part(Part::Callbacks).seconds.mean),
                                       millisecondsText(outside.seconds.mean), ratio(outside.speedUp)});
    }
    return cells;
}

// One line for all engines that failed in the same way, as at a world that none can load.
std::string failures(const WorldResult &result, const std::vector<EngineSummary> &summaries) {
    std::vector<std::pair<std::string, std::string>> namesByFailure;  // in order
    for (std::size_t i = 0; i < summaries.size(); ++i) {
        const EngineResult &engine = result.engines[i];
        if (!engine.failed()) continue;
        const auto known = std::find_if(namesByFailure.begin(), namesByFailure.end(),
                                        [&](const auto &other) { return other.first == engine.failure; });
        if (known == namesByFailure.end())
            namesByFailure.emplace_back(engine.failure, summaries[i].engine);
        else
            known->second += ", " + summaries[i].engine;
    }
    std::string text;
    for (const auto &[failure, names] : namesByFailure) text += "FAILED: " + names + ": " + failure + "\n";
    return text;
}

// What a reader must not overlook, one line each.
std::string notes(const WorldResult &result, const std::vector<EngineSummary> &summaries) {
    std::string text = failures(result, summaries);
    for (std::size_t i = 0; i < summaries.size(); ++i) {
        const EngineResult &engine = result.engines[i];
        const std::string name = summaries[i].engine;
        if (engine.firstDifference >= 0)
            text += format("WRONG RESULT: %s: state differs after frame %ld or before\n", name.c_str(),
                           engine.firstDifference);
        if (summaries[i].messages)
            text += format("note: %s: %u messages of ODE\n", name.c_str(), summaries[i].messages);
    }
    if (result.hasSeveralReleases())
        text += "note: the releases of ODE differ, so results may: states are compared within each release alone\n";
    std::set<std::string> known;  // engines load the same world
    for (const EngineResult &engine : result.engines)
        for (const std::string &warning : engine.ready.warnings)
            if (known.insert(warning).second) text += "note: " + warning + "\n";
    return text;
}

}  // namespace

std::string reportText(const WorldResult &result) {
    using Align = Table::Align;
    std::vector<Table::Column> columns = {{"engine", Align::Left},
                                          {"frame ms"},
                                          {"collision"},
                                          {"dynamics"},
                                          {"overhead"},
                                          {"speed-up: frame"},
                                          {"collision"},
                                          {"dynamics"},
                                          {"overhead"},
                                          {"× real time"},
                                          {"shared"},
                                          {"state", Align::Left}};
    const bool callbacksTimed = result.callbacksTimed();
    if (callbacksTimed)
        columns.insert(columns.end() - 1, {{"callbacks ms"}, {"frame outside"}, {"speed-up outside"}});
    Table table(columns);
    const std::vector<EngineSummary> summaries = summarize(result);
    for (std::size_t i = 0; i < summaries.size(); ++i)
        if (!result.engines[i].batches.empty())
            table.addRow(cells(summaries[i], result.engines[i].engine.isOurs(), callbacksTimed));
    return title(result) + table.text() + notes(result, summaries) + "\n";
}

}  // namespace bench
