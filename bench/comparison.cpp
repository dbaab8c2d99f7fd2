#include "comparison.h"

#include "support/text.h"
#include "table.h"
#include "support/statistics.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace bench {

using nlohmann::json;

namespace {

struct Figures {
    double seconds;  // of a frame
    support::Spread speedUp;
    bool isReference;
};

using Key = std::pair<std::string, std::string>;  // world, engine

struct Run {
    std::vector<Key> order;
    std::map<Key, std::optional<Figures>> figures;  // none: the engine failed
};

Figures figuresOf(const json &engine, bool isReference) {
    const json &frame = engine.at("parts").at("frame"), &speedUp = frame.at("speedUp");
    support::Spread spread{};
    speedUp.at("median").get_to(spread.median);
    speedUp.at("lowerQuartile").get_to(spread.lowerQuartile);
    speedUp.at("upperQuartile").get_to(spread.upperQuartile);
    return {frame.at("meanSeconds").get<double>(), spread, isReference};
}

Run readRun(const std::string &file) {
    std::ifstream stream(file);
    if (!stream) throw std::runtime_error("cannot read " + support::quote(file));
    Run run;
    try {
        const json results = json::parse(stream);
        for (const json &world : results.at("worlds")) {
            bool isReference = true;
            for (const json &engine : world.at("engines")) {
                const Key key = {world.at("world").get<std::string>(), engine.at("engine").get<std::string>()};
                const bool hasFailed = !engine.at("failure").get<std::string>().empty();
                run.figures[key] = hasFailed ? std::nullopt : std::optional(figuresOf(engine, isReference));
                run.order.push_back(key);
                isReference = false;
            }
        }
    } catch (const json::exception &) {  // its words are of the library's inside
        throw std::runtime_error(support::quote(file) + " holds no results of odemt_bench");
    }
    return run;
}

std::string spreadText(const support::Spread &spread) {
    return numberText(spread.median) + " [" + numberText(spread.lowerQuartile) + ", " + numberText(spread.upperQuartile) + "]";
}

std::string verdict(const Figures &before, const Figures &after) {
    if (before.isReference && after.isReference) return "reference";
    if (after.speedUp.lowerQuartile > before.speedUp.upperQuartile) return "faster";
    if (after.speedUp.upperQuartile < before.speedUp.lowerQuartile) return "slower";
    return "no difference";
}

// Returns what a file has of it; null: it is not in the file.
const std::optional<Figures> *find(const Run &run, const Key &key) {
    const auto found = run.figures.find(key);
    return found != run.figures.end() ? &found->second : nullptr;
}

// Of what cannot be compared. Null: not in that file.
std::string mark(const std::optional<Figures> *was, const std::optional<Figures> *is) {
    if (was == nullptr) return *is ? "only after" : "only after, failed";
    if (is == nullptr) return *was ? "only before" : "only before, failed";
    return *was ? "failed after" : *is ? "failed before" : "failed in both";
}

void addRow(Table &table, const Key &key, const std::optional<Figures> *was, const std::optional<Figures> *is) {
    const bool has = was != nullptr && *was, hasNow = is != nullptr && *is;
    table.addRow({support::printable(key.first), support::printable(key.second), has ? millisecondsText((*was)->seconds) : "-",
                  hasNow ? millisecondsText((*is)->seconds) : "-", has ? spreadText((*was)->speedUp) : "-",
                  hasNow ? spreadText((*is)->speedUp) : "-", has && hasNow ? verdict(**was, **is) : mark(was, is)});
}

}  // namespace

std::string compareResults(const std::string &before, const std::string &after) {
    const Run one = readRun(before), other = readRun(after);
    Table table({{"world", Table::Align::Left},
                 {"engine", Table::Align::Left},
                 {"ms before"},
                 {"after"},
                 {"speed-up before"},
                 {"after"},
                 {"", Table::Align::Left}});
    bool areCommon = false;
    for (const Key &key : one.order) {
        const auto *const was = find(one, key), *const is = find(other, key);
        areCommon = areCommon || (*was && is != nullptr && *is);
        addRow(table, key, was, is);
    }
    for (const Key &key : other.order)
        if (find(one, key) == nullptr) addRow(table, key, nullptr, find(other, key));
    if (!areCommon) throw std::runtime_error(support::quote(before) + " and " + support::quote(after) + " have no world and engine in common");
    return table.text() + "\nfaster, slower: quartiles of the speed-ups over the first engine of the same run do not overlap.\n";
}

}  // namespace bench
