// Predictions and their validation, as tables for people and lines for files.
#pragma once

#include "scale/measured_world.h"
#include "scale/step_simulation.h"
#include "scale/world_measure.h"

#include <string>
#include <vector>

namespace scale {

// One world behind one network.
struct NetworkScaling {
    Network network;
    std::vector<double> frameNs;  // for each number of workers
    // The smallest number of workers twice as many of which make a frame less than five per cent shorter; 0: none makes it a tenth shorter than home.
    unsigned enough = 0;
};

NetworkScaling predictScaling(const MeasuredWorld &measured, const Network &network, const std::vector<unsigned> &workers);

// Two lines: a frame and a step at home, islands, bytes, time of the solver.
std::string describe(const MeasuredWorld &measured);
// Frames at home over frames with workers.
std::string scalingTable(const std::vector<NetworkScaling> &scalings, const std::vector<unsigned> &workers);
std::string scalingHeader();
std::string scalingLines(const MeasuredWorld &measured, const std::vector<NetworkScaling> &scalings, const std::vector<unsigned> &workers);

struct Validation {
    Cluster cluster;
    double predictedNs;
    MeasuredFrames measured;

    double error() const { return predictedNs / measured.clusterNs - 1; }
    bool isGood() const;  // within a fifth
};

// A line each, as measuring takes long.
std::string validationTitles();
std::string validationRow(const Validation &row);
std::string validationHeader();
std::string validationLine(const MeasuredWorld &measured, const Validation &row);

}  // namespace scale
