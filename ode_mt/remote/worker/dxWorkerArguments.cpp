#include "remote/worker/dxWorkerArguments.h"

#include <cmath>
#include <cstdlib>
#include <sstream>

namespace {

struct Unit {
    const char *name;
    double factor;
};

constexpr Unit kTimes[] = {{"ns", 1}, {"us", 1e3}, {"ms", 1e6}, {"s", 1e9}};                                               // ns
constexpr Unit kRates[] = {{"B/s", 1},         {"kB/s", 1e3},       {"MB/s", 1e6},         {"GB/s", 1e9},
                           {"bit/s", 1.0 / 8}, {"kbit/s", 1e3 / 8}, {"Mbit/s", 1e6 / 8}, {"Gbit/s", 1e9 / 8}};  // bytes a second

// A number and a unit, without a blank. False: it is none, or not positive.
template <std::size_t Count>
bool read(const std::string &text, const Unit (&units)[Count], double &value) {
    char *end = nullptr;
    value = std::strtod(text.c_str(), &end);
    if (end == text.c_str() || !(value > 0) || !std::isfinite(value)) return false;
    for (const Unit &unit : units) {
        if (std::string(end) != unit.name) continue;
        value *= unit.factor;
        return true;
    }
    return false;
}

}  // namespace

std::vector<std::string> dxWorkerArgumentsOfEnvironment() {
    const char *const text = std::getenv("ODEMT_WORKER_ARGUMENTS");
    std::istringstream stream(text == nullptr ? "" : text);
    std::vector<std::string> words;
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

std::string dxReadWorkerArguments(const std::vector<std::string> &words, dxWorkerArguments &arguments) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string &option = words[i];
        if (option != "--delay" && option != "--bandwidth" && option != "--record") return "unknown option '" + option + "'";
        if (i + 1 == words.size()) return option + ": its value is missing";
        const std::string &text = words[++i];
        double value = 0;
        if (option == "--record") {
            arguments.record = text;
        } else if (option == "--delay") {
            if (!read(text, kTimes, value) || value > dxSimulatedLink::kMaxDelayNs)
                return option + ": '" + text + "' is no time up to 1s, as 50us or 1ms";
            arguments.link.delayNs = value;
        } else {
            if (!read(text, kRates, value)) return option + ": '" + text + "' is no rate, as 117MB/s or 1Gbit/s";
            arguments.link.nsPerByte = 1e9 / value;
        }
    }
    return {};
}
