#include "remote/islands/dxRemoteShare.h"

#include <algorithm>

namespace {

// Estimates of sizes of problems, before rows are known: contacts and joints of machines have three to five rows.
constexpr double kBytesPerJoint = 550, kBytesPerBody = 144;

// Overhead in this process for each island: locks, two copies, the result. Units: ns.
constexpr double kIslandNs = 3e3, kCopyNsPerByte = 0.3;

constexpr double kMinGain = 0.1, kMinGainNs = 30e3;

}  // namespace

double dxPredictRemoteShare(const dxRemoteWork &work, unsigned localThreads, const dxRemoteCapacity &capacity) {
    if (capacity.workers == 0 || work.islands < 2 || !(work.totalNs > 0)) return 0;
    const double threads = localThreads, bytes = kBytesPerJoint * work.joints + kBytesPerBody * work.bodies;
    const double away = kRemoteSolverPart * work.totalNs / capacity.speed + bytes * capacity.nsPerByte;
    const double left = (1 - kRemoteSolverPart) * work.totalNs + work.islands * kIslandNs + bytes * kCopyNsPerByte;
    const double alone = std::max(work.totalNs / threads, work.largestNs);

    // (H + f (P - H)) / w = L + f A
    const double slope = away + (work.totalNs - left) / threads;
    if (slope <= 0) return 0;
    const double share = std::clamp((work.totalNs / threads - capacity.latencyNs) / slope, 0.0, 1.0);
    const double local = (work.totalNs + share * (left - work.totalNs)) / threads;
    const double together = std::max({local, capacity.latencyNs + share * away, std::min(work.largestNs, alone)});
    const double gain = alone - together;
    return gain > kMinGain * alone && gain > kMinGainNs ? share : 0;
}
