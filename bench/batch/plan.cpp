#include "batch/plan.h"

#include "batch/parameter.h"
#include "support/text.h"
#include "loader/load_world.h"
#include "protocol.h"
#include "scenes/fnv1a.h"
#include "support/text_file.h"
#include "world_source.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <functional>
#include <set>
#include <stdexcept>

namespace batch {

namespace {

constexpr long kMaxRuns = 1'000'000'000;

// Columns of the table that are always there.
const std::array<const char *, 8> kColumns = {"run", "world", "seed", "status", "message", "frames", "time", "hash"};
const std::set<std::string> kSeriesColumns = {"run", "frame", "time", "hash"};

void checkKeys(const Json &object, const std::string &where, const std::vector<std::string> &known) {
    for (const auto &[key, value] : object.items())
        if (std::find(known.begin(), known.end(), key) == known.end())
            fail(where.empty() ? key : where + "." + key, "unknown key; known: " + support::join(known));
}

double numberOf(const Json &value, const std::string &key) {
    if (!value.is_number()) fail(key, "'" + value.dump() + "' is not a number");
    const double number = value.get<double>();
    if (!std::isfinite(number)) fail(key, "the number is not finite");
    return number;
}

long wholeOf(const Json &value, const std::string &key, long least, long most) {
    const bool isWhole = value.is_number() && std::trunc(value.get<double>()) == value.get<double>();  // 1e3 is
    if (!isWhole || value < least || value > most)
        fail(key, "'" + value.dump() + "' is not a whole number from " + std::to_string(least) + " to " + std::to_string(most));
    return value.get<long>();
}

std::string textOf(const Json &value, const std::string &key) {
    if (!value.is_string() || value.get<std::string>().empty()) fail(key, "'" + value.dump() + "' is not a text");
    return value.get<std::string>();
}

bool switchOf(const Json &value, const std::string &key) {
    if (!value.is_boolean()) fail(key, "is not true or false");
    return value.get<bool>();
}

// A list as it stands, or one value.
std::vector<Json> listOf(const Json &value, const std::string &key) {
    if (!value.is_array()) return {value};
    if (value.empty()) fail(key, "the list is empty");
    return {value.begin(), value.end()};
}

// {"from": 1, "to": 2, "step": 0.25}
std::vector<Json> rangeOf(const Json &range, const std::string &key) {
    checkKeys(range, key, {"from", "to", "step"});
    for (const char *const part : {"from", "to", "step"})
        if (!range.contains(part)) fail(key, std::string("a range has no '") + part + "'");
    const double from = numberOf(range["from"], key + ".from"), to = numberOf(range["to"], key + ".to"),
                 step = numberOf(range["step"], key + ".step");
    if (step == 0 || (to - from) / step < 0)
        fail(key, "a step of " + range["step"].dump() + " does not lead from " + range["from"].dump() + " to " + range["to"].dump());
    constexpr double kRounding = 1e-9;  // of a step: 0.1 + 0.1 + 0.1 is 0.3
    const double count = std::floor((to - from) / step + kRounding);
    if (count >= static_cast<double>(kMaxRuns)) fail(key, "too many values");
    const bool areWhole = range["from"].is_number_integer() && range["step"].is_number_integer();
    std::vector<Json> values;
    for (long i = 0; i <= static_cast<long>(count); ++i)
        values.push_back(areWhole ? Json(range["from"].get<long>() + i * range["step"].get<long>()) : Json(from + static_cast<double>(i) * step));
    return values;
}

void readWorlds(const Json &value, Plan &plan) {
    for (const Json &world : listOf(value, "worlds")) plan.worlds.push_back(textOf(world, "worlds"));
}

bool isSimple(const Json &value) { return value.is_number() || value.is_string() || value.is_boolean(); }

void readParameters(const Json &value, Plan &plan) {
    if (!value.is_object()) fail("parameters", "is not an object");
    for (const auto &[name, values] : value.items()) {
        const std::string key = "parameters." + name;
        Parameter parameter{name, values.is_object() ? rangeOf(values, key) : listOf(values, key)};
        for (const Json &each : parameter.values)
            if (!isSimple(each)) fail(key, "'" + each.dump() + "' is not a number, a text, true or false");
        plan.parameters.push_back(std::move(parameter));
    }
}

void readSeeds(const Json &value, Plan &plan) {
    constexpr long kMost = 4294967295;
    if (!value.is_object()) {
        for (const Json &seed : listOf(value, "seeds")) plan.seeds.push_back(static_cast<std::uint32_t>(wholeOf(seed, "seeds", 0, kMost)));
        return;
    }
    checkKeys(value, "seeds", {"from", "count"});
    const long from = value.contains("from") ? wholeOf(value["from"], "seeds.from", 0, kMost) : 1;
    if (!value.contains("count")) fail("seeds", "there is no 'count'");
    const long count = wholeOf(value["count"], "seeds.count", 1, kMaxRuns);
    if (from + count - 1 > kMost) fail("seeds", "seeds end at " + std::to_string(kMost));
    for (long i = 0; i < count; ++i) plan.seeds.push_back(static_cast<std::uint32_t>(from + i));
}

void readLength(const Json &plan, Plan &into) {
    if (plan.contains("frames") == plan.contains("seconds")) fail("frames", "one of 'frames' and 'seconds' says how long a run is");
    if (plan.contains("frames")) into.frames = wholeOf(plan["frames"], "frames", 1, Plan::kMaxFrames);
    if (!plan.contains("seconds")) return;
    into.seconds = numberOf(plan["seconds"], "seconds");
    if (!(into.seconds > 0)) fail("seconds", "'" + plan["seconds"].dump() + "' is not above 0");
}

void readPerturbation(const Json &value, Plan &plan) {
    if (!value.is_object()) fail("perturbation", "is not an object");
    checkKeys(value, "perturbation", {"position", "velocity"});
    const auto read = [&](const char *key, double &into) {
        if (!value.contains(key)) return;
        into = numberOf(value[key], std::string("perturbation.") + key);
        if (into < 0) fail(std::string("perturbation.") + key, "is below 0");
    };
    read("position", plan.perturbation.position);
    read("velocity", plan.perturbation.velocity);
}

void readObservables(const Json &value, Plan &plan) {
    if (!value.is_object()) fail("observables", "is not an object");
    for (const auto &[name, expression] : value.items()) {
        const std::string key = "observables." + name;
        try {
            plan.observables.push_back(readObservable(name, textOf(expression, key)));
        } catch (const ObservableError &error) {
            fail(key, error.what());
        }
    }
}

void readSeries(const Json &value, Plan &plan) {
    if (!value.is_object()) fail("series", "is not an object");
    checkKeys(value, "series", {"every", "observables", "states"});
    if (!value.contains("every")) fail("series", "there is no 'every'");
    plan.every = wholeOf(value["every"], "series.every", 1, Plan::kMaxFrames);
    if (value.contains("states")) plan.hasStates = switchOf(value["states"], "series.states");
    if (!value.contains("observables")) return;
    for (const Json &name : listOf(value["observables"], "series.observables")) {
        const std::string wanted = textOf(name, "series.observables");
        const auto found = std::find_if(plan.observables.begin(), plan.observables.end(),
                                        [&](const Observable &observable) { return observable.name == wanted; });
        if (found == plan.observables.end()) fail("series.observables", "there is no observable '" + wanted + "'");
        if (found->over != Observable::Over::End) fail("series.observables", "'" + wanted + "' is one value for all frames");
        const bool isThere = std::any_of(plan.series.begin(), plan.series.end(), [&](const Observable &other) { return other.name == wanted; });
        if (isThere) fail("series.observables", "'" + wanted + "' is there twice");
        plan.series.push_back(*found);
    }
}

// SQLite does not tell capitals from small letters in them.
std::string lowered(std::string name) {
    for (char &letter : name) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return name;
}

void checkColumns(const Plan &plan) {
    std::set<std::string> columns(kColumns.begin(), kColumns.end());
    const auto add = [&](const std::string &key, const std::string &name) {
        if (name.empty()) fail(key, "a column has no name");
        if (name.find('\0') != std::string::npos) fail(key, "the name of a column has a null character");
        if (!columns.insert(lowered(name)).second) fail(key + "." + name, "there is a column of this name already");
    };
    for (const Parameter &parameter : plan.parameters) add("parameters", parameter.name);
    for (const Observable &observable : plan.observables) add("observables", observable.name);
    for (const Observable &observable : plan.series)
        if (kSeriesColumns.count(lowered(observable.name)) != 0)
            fail("series.observables", "'" + observable.name + "' is the name of another column of the series");
}

void checkCounts(const Plan &plan) {
    if (!plan.isGrid)
        for (const Parameter &parameter : plan.parameters)
            if (parameter.values.size() != plan.parameters.front().values.size())
                fail("parameters." + parameter.name, "has " + std::to_string(parameter.values.size()) + " values, and '" +
                                                         plan.parameters.front().name + "' has " +
                                                         std::to_string(plan.parameters.front().values.size()) + ": of lists, each has as many");
    double count = static_cast<double>(plan.worlds.size() * plan.seeds.size());
    if (plan.isGrid)
        for (const Parameter &parameter : plan.parameters) count *= static_cast<double>(parameter.values.size());
    if (count > kMaxRuns) fail("parameters", "more than " + std::to_string(kMaxRuns) + " runs");
}

// Worlds with the values of parameters in their names, each once.
std::vector<std::string> worldsOfRunsOf(const Plan &plan) {
    std::vector<std::string> list;
    std::set<std::string> known;
    for (long i = 0; i < plan.count(); i += static_cast<long>(plan.seeds.size())) {
        const std::string world = plan.run(i).world;
        if (known.insert(world).second) list.push_back(world);
    }
    return list;
}

// Each name must mean something in each world, and each value must be one that it can have.
void checkParameters(const Plan &plan, const std::vector<std::string> &worldsOfRuns) {
    for (const std::string &world : plan.worlds)
        for (const Parameter &parameter : plan.parameters)
            for (const Json &value : parameter.values) checkParameter(parameter.name, value, world);
    for (const std::string &world : worldsOfRuns) {
        if (world.find("${") != std::string::npos) fail("worlds", "'" + world + "' names a parameter that there is not");
        try {
            bench::checkWorld(world);
        } catch (const std::exception &error) {
            fail("worlds", error.what());
        }
    }
}

std::string fingerprintOf(const Plan &plan, const std::vector<std::string> &worldsOfRuns) {
    scenes::Fnv1a hash;
    const auto add = [&hash](const std::string &text) {
        hash.add(text.data(), text.size());
        hash.add("\xff", 1);  // ends it
    };
    add(plan.text);
    std::set<std::string> files;
    for (const std::string &world : worldsOfRuns) {
        const bench::WorldSpec spec = bench::readWorldSpec(world);
        if (spec.isSdf && files.insert(spec.name).second) add(support::readTextFile(worlds::findWorld(spec.name)));
    }
    return bench::hashText(hash.value());
}

// Throws for what the parser lets pass: of a key that is there twice it would take the last value.
class Keys {
public:
    bool operator()(int, Json::parse_event_t event, const Json &parsed) {
        using Event = Json::parse_event_t;
        if (event == Event::object_start || event == Event::array_start) {
            if (m_open.size() >= kMaxDepth) fail(path(), "is nested more than " + std::to_string(kMaxDepth) + " deep");
            m_open.emplace_back();
        } else if (event == Event::object_end || event == Event::array_end) {
            m_open.pop_back();
        } else if (event == Event::key) {
            m_open.back().last = parsed.get<std::string>();
            if (!m_open.back().all.insert(m_open.back().last).second) fail(support::printable(path()), "the key is there twice");
        }
        return true;
    }

private:
    static constexpr std::size_t kMaxDepth = 100;  // no plan needs more than four; what is written with recursion bears it

    struct Open {
        std::set<std::string> all;
        std::string last;  // empty in a list
    };

    std::string path() const {
        std::string path;
        for (const Open &open : m_open)
            if (!open.last.empty()) path += (path.empty() ? "" : ".") + open.last;
        return path.empty() ? "plan" : path;
    }

    std::vector<Open> m_open;  // objects and lists, the outer one first
};

Json parse(const std::string &text) {
    Keys keys;
    try {
        return Json::parse(text, std::ref(keys));
    } catch (const Json::exception &error) {
        throw std::invalid_argument("plan: not JSON: " + support::printable(error.what()));
    }
}

}  // namespace

long Plan::combinations() const {
    if (parameters.empty()) return 1;
    if (!isGrid) return static_cast<long>(parameters.front().values.size());
    long count = 1;
    for (const Parameter &parameter : parameters) count *= static_cast<long>(parameter.values.size());
    return count;
}

long Plan::count() const { return static_cast<long>(worlds.size() * seeds.size()) * combinations(); }

Run Plan::run(long number) const {
    const long seedCount = static_cast<long>(seeds.size());
    Run run{number, worlds[static_cast<std::size_t>(number / (seedCount * combinations()))], {}, seeds[static_cast<std::size_t>(number % seedCount)]};
    const long combination = number / seedCount % combinations();
    long rest = combination;
    for (auto parameter = parameters.rbegin(); parameter != parameters.rend(); ++parameter) {
        const long size = static_cast<long>(parameter->values.size());
        run.values.emplace_back(parameter->name, parameter->values[static_cast<std::size_t>(isGrid ? rest % size : combination)]);
        rest /= size;
    }
    std::reverse(run.values.begin(), run.values.end());
    for (const auto &[name, value] : run.values) insertValue(run.world, name, value);
    return run;
}

Plan readPlan(const std::string &text) {
    const Json json = parse(text);
    if (!json.is_object()) throw std::invalid_argument("plan: not a JSON object");
    checkKeys(json, "",
              {"worlds", "parameters", "expand", "seeds", "frames", "seconds", "perturbation", "observables", "series", "ignore_unsupported"});
    if (!json.contains("worlds")) fail("worlds", "there are none");
    Plan plan;
    plan.text = json.dump();
    readWorlds(json["worlds"], plan);
    if (json.contains("parameters")) readParameters(json["parameters"], plan);
    if (json.contains("expand")) {
        const std::string how = textOf(json["expand"], "expand");
        if (how != "grid" && how != "list") fail("expand", "'" + how + "' is unknown; known: grid, list");
        plan.isGrid = how == "grid";
    }
    readSeeds(json.contains("seeds") ? json["seeds"] : Json(1), plan);
    readLength(json, plan);
    if (json.contains("perturbation")) readPerturbation(json["perturbation"], plan);
    if (json.contains("observables")) readObservables(json["observables"], plan);
    if (json.contains("series")) readSeries(json["series"], plan);
    if (json.contains("ignore_unsupported")) plan.ignoreUnsupported = switchOf(json["ignore_unsupported"], "ignore_unsupported");
    checkColumns(plan);
    checkCounts(plan);
    const std::vector<std::string> worldsOfRuns = worldsOfRunsOf(plan);
    checkParameters(plan, worldsOfRuns);
    plan.fingerprint = fingerprintOf(plan, worldsOfRuns);
    return plan;
}

}  // namespace batch
