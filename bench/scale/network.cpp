#include "scale/network.h"

#include <cmath>
#include <cstdio>
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

}  // namespace scale
