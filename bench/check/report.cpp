#include "check/report.h"

#include <nlohmann/json.hpp>

#include "support/text.h"
#include "table.h"

namespace check {

namespace {

using Json = nlohmann::ordered_json;

// "-" where a time is too short to be divided by.
std::string ratioText(double first, double second) { return second > 0 ? bench::numberText(first / second) : "-"; }

std::string enginesText(const std::vector<EngineResult> &engines) {
    using Align = bench::Table::Align;
    bench::Table table(
        {{"", Align::Left}, {"steps"}, {"seconds"}, {"of CPU"}, {"in steps"}, {"times as fast"}, {"in steps"}, {"", Align::Left}});
    for (const EngineResult &engine : engines) {
        const bool isFirst = &engine == &engines.front();
        table.addRow({engine.name, std::to_string(engine.steps), bench::numberText(engine.seconds),
                      bench::numberText(engine.cpuSeconds), bench::numberText(engine.stepSeconds),
                      isFirst ? "" : ratioText(engines[0].seconds, engine.seconds),
                      isFirst ? "" : ratioText(engines[0].stepSeconds, engine.stepSeconds), engine.result});
    }
    return table.text();
}

std::string valuesText(const Finding &finding) {
    using Align = bench::Table::Align;
    const bool isItself = finding.engine == "libode8";
    bench::Table table({{"", Align::Left},
                        {isItself ? "first run" : "libode8", Align::Left},
                        {isItself ? "second run" : finding.engine, Align::Left}});
    for (const ValueDifference &value : finding.state->values)
        table.addRow({(value.body ? "body " + std::to_string(*value.body) + ", " : "") + value.field, value.left, value.right});
    std::string text = "Step " + std::to_string(finding.step) + " of " + finding.world + ":\n\n" + table.text();
    if (finding.state->differentBodies > 0)
        text += "\n" + std::to_string(finding.state->differentBodies) + " of " + std::to_string(finding.state->bodies) +
                " bodies differ.\n";
    return text;
}

Json asJson(const Finding &finding) {
    Json json = {{"engine", finding.engine}, {"step", finding.step}, {"world", finding.world}};
    if (!finding.state) return json;
    json["differentBodies"] = finding.state->differentBodies;
    json["bodies"] = finding.state->bodies;
    json["values"] = Json::array();
    for (const ValueDifference &value : finding.state->values)
        json["values"].push_back({{"body", value.body ? Json(*value.body) : Json()},
                                  {"field", value.field},
                                  {"libode8", value.left},
                                  {"other", value.right}});
    return json;
}

}  // namespace

std::string reportText(const CheckResult &result) {
    constexpr double kShort = 0.5;  // seconds, in which a program mostly starts
    std::string text = enginesText(result.engines) + '\n' + support::printable(result.sentence) + '\n';
    for (const std::string &remark : result.remarks) text += support::printable(remark) + '\n';
    if (result.engines.size() > 1 && result.engines[0].seconds < kShort) text += "Runs as short as these say little about speed.\n";
    if (result.finding && result.finding->state) text += '\n' + valuesText(*result.finding);
    return text;
}

std::string reportJson(const CheckResult &result) {
    const char *const verdicts[] = {"equal", "different", "not compared"};
    Json json = {{"verdict", verdicts[static_cast<int>(result.verdict)]},
                 {"sentence", result.sentence},
                 {"remarks", result.remarks},
                 {"steps", result.steps},
                 {"worlds", result.worlds},
                 {"bodies", result.bodies},
                 {"engines", Json::array()}};
    for (const EngineResult &engine : result.engines)
        json["engines"].push_back({{"name", engine.name},
                                   {"library", engine.library},
                                   {"release", engine.release},
                                   {"result", engine.result},
                                   {"ending", engine.ending},
                                   {"steps", engine.steps},
                                   {"seconds", engine.seconds},
                                   {"cpuSeconds", engine.cpuSeconds},
                                   {"stepSeconds", engine.stepSeconds},
                                   {"observerSeconds", engine.observerSeconds}});
    json["difference"] = result.finding ? asJson(*result.finding) : Json();
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace check
