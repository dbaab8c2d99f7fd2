// Measures worlds: at home, with a worker beside it that records what it does, and with workers behind a simulated network.
#pragma once

#include "scale/measured_world.h"
#include "scale/step_simulation.h"

#include <string>

namespace scale {

struct MeasureSettings {
    std::string program;              // odemt_scale_child
    std::string library;              // folder of ODE_MT's libode.so.8
    std::string worker;               // odemt_worker of the same build; empty: there is none, and no MPI
    std::string transport = "mpi";    // or loopback: workers that are threads of the process
    double seconds = 10;              // for all frames of a measurement, about; never fewer than four of each kind
};

// Home with one thread, and with one worker that gets all islands, in turns. Throws std::runtime_error, also if results differ.
MeasuredWorld measureWorld(const std::string &world, const MeasureSettings &settings);

// What the frames of an earlier measurement take with a cluster, and at home in turns with it.
struct MeasuredFrames {
    double homeNs, clusterNs;
    double sent;    // islands a frame
    unsigned late;  // times
};
MeasuredFrames measureFrames(const MeasuredWorld &measured, const Cluster &cluster, const MeasureSettings &settings);

}  // namespace scale
