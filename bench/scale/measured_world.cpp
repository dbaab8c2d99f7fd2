#include "scale/measured_world.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include "remote/worker/dxSimulatedNetwork.h"

namespace scale {

// Delays are of a small message between two processes, half of what a ping takes. Rates are of what is left of the wire for content.
const std::vector<Network> &knownNetworks() {
    static const std::vector<Network> all = {
        {"none", 0, 0},           {"100M", 100e3, 11.7e6}, {"1GbE", 50e3, 117e6},      {"10GbE", 20e3, 1.17e9},
        {"25GbE", 10e3, 2.9e9},   {"infiniband", 2e3, 3e9},
    };
    return all;
}

std::string Network::workerArguments() const {
    char text[100] = "";
    std::string words;
    if (delayNs > 0) {
        std::snprintf(text, sizeof text, "--delay %.0fns", delayNs);
        words = text;
    }
    if (bytesPerSecond > 0) {
        std::snprintf(text, sizeof text, "%s--bandwidth %.0fB/s", words.empty() ? "" : " ", bytesPerSecond);
        words += text;
    }
    return words;
}

Network readNetwork(const std::string &text) {
    std::string names;
    for (const Network &one : knownNetworks()) {
        if (one.name == text) return one;
        names += (names.empty() ? "" : ", ") + one.name;
    }
    double delay = -1, rate = -1;
    char end = 0;
    const bool isRead = std::sscanf(text.c_str(), "%lf/%lf%c", &delay, &rate, &end) == 2;
    if (!isRead || !(delay >= 0) || delay > dxSimulatedLink::kMaxDelayNs || !(rate >= 0) || !std::isfinite(rate))
        throw std::invalid_argument("network '" + text + "' is unknown; known: " + names + ", or DELAY/RATE in ns and bytes a second");
    return {text, delay, rate};
}

using Json = nlohmann::ordered_json;

double typical(std::vector<double> values) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const auto cut = static_cast<std::ptrdiff_t>(values.size() / 4);
    return std::accumulate(values.begin() + cut, values.end() - cut, 0.0) / static_cast<double>(values.size() - 2 * static_cast<std::size_t>(cut));
}

double MeasuredWorld::solveNs() const {
    std::vector<double> sums;
    for (const Step &step : steps) {
        sums.push_back(0);
        for (const Problem &problem : step) sums.back() += problem.solveNs;
    }
    return typical(sums);
}

MeasuredWorld slowedDown(MeasuredWorld measured, double factor) {
    for (double *const ns : {&measured.homeFrameNs, &measured.homeStepNs, &measured.awayStepNs, &measured.nsPerByte}) *ns *= factor;
    for (Step &step : measured.steps)
        for (Problem &problem : step) problem.solveNs *= factor;
    return measured;
}

std::string writeMeasuredWorld(const MeasuredWorld &measured) {
    Json steps = Json::array();
    for (const Step &step : measured.steps) {
        Json problems = Json::array();
        for (const Problem &one : step) problems.push_back({one.bodies, one.joints, one.bytes, one.resultBytes, one.solveNs});
        steps.push_back(problems);
    }
    const Json json = {{"world", measured.world},
                       {"warm_up", measured.warmUp},
                       {"frames", measured.frames},
                       {"home_frame_ns", measured.homeFrameNs},
                       {"home_step_ns", measured.homeStepNs},
                       {"away_step_ns", measured.awayStepNs},
                       {"latency_ns", measured.latencyNs},
                       {"ns_per_byte", measured.nsPerByte},
                       {"sleep_ns", measured.sleepNs},
                       {"problem", {"bodies", "joints", "bytes", "result_bytes", "solve_ns"}},
                       {"steps", steps}};
    return json.dump() + "\n";
}

MeasuredWorld readMeasuredWorld(const std::string &text) {
    try {
        const Json json = Json::parse(text);
        MeasuredWorld measured;
        measured.world = json.at("world");
        measured.warmUp = json.at("warm_up");
        measured.frames = json.at("frames");
        measured.homeFrameNs = json.at("home_frame_ns");
        measured.homeStepNs = json.at("home_step_ns");
        measured.awayStepNs = json.at("away_step_ns");
        measured.latencyNs = json.at("latency_ns");
        measured.nsPerByte = json.at("ns_per_byte");
        measured.sleepNs = json.at("sleep_ns");
        for (const Json &step : json.at("steps")) {
            measured.steps.emplace_back();
            for (const Json &one : step) measured.steps.back().push_back({one.at(0), one.at(1), one.at(2), one.at(3), one.at(4)});
        }
        return measured;
    } catch (const nlohmann::json::exception &error) {
        throw std::runtime_error(std::string("no measured world: ") + error.what());
    }
}

std::vector<Step> readWorkRecord(const std::string &text) {
    std::map<unsigned long long, Step> steps;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        unsigned long long step = 0, number = 0;
        double rows = 0;
        Problem problem;
        if (!(words >> step >> number >> problem.bodies >> problem.joints >> rows >> problem.bytes >> problem.solveNs >> problem.resultBytes))
            throw std::runtime_error("a worker's record has the line '" + line + "'");
        steps[step].push_back(problem);
    }
    std::vector<Step> inOrder;
    for (auto &[number, step] : steps) inOrder.push_back(std::move(step));
    return inOrder;
}

}  // namespace scale
