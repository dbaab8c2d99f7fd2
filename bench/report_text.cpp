#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <utility>
#include <vector>

#include "curve.h"
#include "table.h"
#include "report.h"
#include "summary.h"
#include "support/statistics.h"
#include "support/text.h"

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
        if (summaries[i].work.isKnown()) text += name + ": " + gainText(summaries[i].work.share()) + '\n';
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

namespace {

std::string exponentText(double exponent) {
    return std::isfinite(exponent) ? format("%.2f", exponent) : "";
}

std::vector<Table::Column> columns(const Curve &curve) {
    std::vector<Table::Column> columns = {{"N"}};
    for (Part part : Curve::kReported)
        for (std::size_t i = 0; i < curve.points[0].engines.size(); ++i) {
            const std::string &engine = curve.points[0].engines[i].engine;
            columns.push_back({i == 0 ? nameOf(part) + (" ms: " + engine) : engine});
            columns.push_back({"growth"});
        }
    return columns;
}

std::vector<std::string> cells(const Curve &curve, std::size_t point) {
    std::vector<std::string> cells = {std::to_string(curve.points[point].size)};
    for (Part part : Curve::kReported)
        for (std::size_t engine = 0; engine < curve.points[point].engines.size(); ++engine) {
            cells.push_back(millisecondsText(curve.seconds(part, point, engine)));
            cells.push_back(exponentText(curve.growth(part, point, engine)));
        }
    return cells;
}

}  // namespace

std::string reportCurves(const std::vector<WorldResult> &results) {
    std::string text;
    for (const Curve &curve : curvesOf(results)) {
        Table table(columns(curve));
        for (std::size_t point = 0; point < curve.points.size(); ++point) table.addRow(cells(curve, point));
        text += "== " + curve.world + ": time over size ==\n\n" + table.text() + "\n";
    }
    return text;
}

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

namespace {

// Returns the place of the fastest engine of ours; -1 if there is none beside the reference.
long fastestOfOurs(const WorldResult &result, const std::vector<EngineSummary> &summaries) {
    long fastest = -1;
    double most = 0;
    for (std::size_t i = 1; i < summaries.size(); ++i) {
        const double speedUp = summaries[i].part(Part::Frame).speedUp.median;
        const bool hasBits = summaries[i].check == StateCheck::Same || summaries[i].check == StateCheck::OtherRelease;
        const bool isComparable = summaries[i].failure.empty() && hasBits;
        if (!result.engines[i].engine.isOurs() || !isComparable || !(speedUp > most)) continue;
        most = speedUp;
        fastest = static_cast<long>(i);
    }
    return fastest;
}

// What the first engine is, for people who have not chosen it.
std::string inPlainWords(const std::string &engine) { return engine == "stock" ? "libode8" : engine; }

}  // namespace

std::string reportSentence(const std::vector<WorldResult> &results) {
    std::string text;
    bool areClean = true, areOfOneRelease = true;
    for (const WorldResult &result : results) {
        areClean = result.isClean() && areClean;
        const std::vector<EngineSummary> summaries = summarize(result);
        const long fastest = fastestOfOurs(result, summaries);
        if (fastest < 0) continue;
        const EngineSummary &engine = summaries[static_cast<std::size_t>(fastest)];
        const std::string &release = result.engines[static_cast<std::size_t>(fastest)].ready.release;
        areOfOneRelease = !areOtherReleases(result.engines[0].ready.release, release) && areOfOneRelease;
        const std::string factor = numberText(engine.part(Part::Frame).speedUp.median) + " times";
        text += text.empty() ? "ODE_MT runs at " + factor + " the speed of " + inPlainWords(summaries[0].engine) : ", at " + factor;
        text += " on " + support::printable(result.world) + " (" + engine.engine + ")";
    }
    if (text.empty()) return text;
    if (areClean && !areOfOneRelease) return text + "; the releases of ODE differ, so results may.\n";
    return text + (areClean ? ", with the same results in every bit.\n" : "; an engine failed or gave other results.\n");
}

}  // namespace bench
