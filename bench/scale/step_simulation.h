// Predicts how long steps take with remote workers: plays, event by event, what dxIslandParallelStep, dxRemoteScheduler and dxRemoteServer do, with
// measured costs and a network that is assumed. What an island is thought to cost, which islands go out, when a link may be given more, how much goes
// into a message, when home takes problems back and when a worker is late is decided by the library's own code (dxCostModel, dxRemoteShare,
// dxRemoteLink, dxRemoteSchedule), for which time is a number.
//
//   home's thread     makes problems, steps the islands that stay, applies results, solves what nobody has; in between sends and receives, one
//                     message at a time: a price each, and a price a byte (checksum, copies)
//   home's wire       bytes one after the other in each direction, whoever they are for; then the delay
//   each worker       a wire, a thread: one message at a time
//
// Assumed: home has one thread for islands, and another core for the thread that communicates while these are long; workers solve as fast as the one
// that was measured; a message makes progress while both ends compute.
//
// Units: ns.
#pragma once

#include "scale/measured_world.h"

#include <memory>

namespace scale {

struct Cluster {
    unsigned workers = 1;
    Network network;
    // What is asked for by name, ODE_MT_ALGORITHM=lcp: all islands go out, and home waits.
    bool sendsAll = false;
    // Workers' simulated networks do not share home's wire.
    bool sharesWire = true;
    // Of the one machine on which all processes are; 0: each has a core of its own.
    unsigned cores = 0;
};

class StepSimulation {
public:
    StepSimulation(const MeasuredWorld &measured, const Cluster &cluster);
    ~StepSimulation();

    // How long the next step takes; steps follow one another, and links learn. Without workers, or if nothing would be sent: as at home.
    double run(const Step &step);

    struct Counts {
        std::size_t sent = 0, takenBack = 0, messages = 0;
        double bytes = 0;  // both directions
    };
    Counts counts() const;

private:
    class Play;
    std::unique_ptr<Play> m_play;
};

// A typical frame. Where remote workers would make it longer, the library returns home; not with sendsAll.
double predictFrame(const MeasuredWorld &measured, const Cluster &cluster);

}  // namespace scale
