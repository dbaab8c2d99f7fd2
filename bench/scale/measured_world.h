// What is measured of a world, from which frames with remote workers are predicted. Kept as JSON, so that a prediction can be made again.
//
// Units: ns; of frames and steps the mean of the middle half.
#pragma once

#include <string>
#include <vector>

namespace scale {

// Networks between home and workers, by the figures that their makers and users know.
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

// An island's problem, as it was sent to a worker.
struct Problem {
    double bodies = 0, joints = 0;
    double bytes = 0, resultBytes = 0;
    double solveNs = 0;  // the worker's processor
};

using Step = std::vector<Problem>;

struct MeasuredWorld {
    std::string world;
    int warmUp = 0, frames = 0;              // those before the measured ones, and the measured ones
    double homeFrameNs = 0, homeStepNs = 0;  // all islands at home, one thread
    double awayStepNs = 0;                   // home's thread, without waiting, in a step of which all islands are solved by a worker
    double latencyNs = 0, nsPerByte = 0;     // there and back; what the library measured of the link to the worker beside it
    double sleepNs = 0;                      // that a thread sleeps longer than it wants to
    std::vector<Step> steps;

    double solveNs() const;  // of a step
    double restNs() const { return homeFrameNs - homeStepNs; }
};

// The same on a machine that takes `factor` times as long for everything but for sleeping.
MeasuredWorld slowedDown(MeasuredWorld measured, double factor);

std::string writeMeasuredWorld(const MeasuredWorld &measured);
// Throws std::runtime_error.
MeasuredWorld readMeasuredWorld(const std::string &json);

// Steps of a worker's record (ode_mt/remote/worker/dxWorkRecord.h), in their order. Throws std::runtime_error.
std::vector<Step> readWorkRecord(const std::string &text);

// Mean of the middle half: of values that come in two heaps, it does not jump from one to the other.
double typical(std::vector<double> values);

}  // namespace scale
