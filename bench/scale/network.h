// Networks between home and workers, by the figures that their makers and users know.
#pragma once

#include <string>
#include <vector>

namespace scale {

struct Network {
    std::string name;
    double delayNs;         // one way
    double bytesPerSecond;  // 0: as many as the software can copy

    double nsPerByte() const { return bytesPerSecond > 0 ? 1e9 / bytesPerSecond : 0; }
    bool isSlowed() const { return delayNs > 0 || bytesPerSecond > 0; }
    // As odemt_worker reads it; empty: no network is simulated.
    std::string workerArguments() const;
};

// The machine itself, then 100 Mbit/s to InfiniBand.
const std::vector<Network> &knownNetworks();

// A known name, or DELAY/RATE in ns and bytes a second, of which either may be 0: "1e6/117e6". Throws std::invalid_argument.
Network readNetwork(const std::string &text);

}  // namespace scale
