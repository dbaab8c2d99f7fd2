// What driver and child say to each other: one JSON object a line.
//
//   child:  {"ready": …}             once, after the world has been built
//   driver: {"frames": K}            run K frames
//   child:  {"batch": …}             their times and the state at their end
//   child:  {"error": "…"}           instead of any answer, before it exits
//
// The child ends when its standard input does.
#pragma once

#include "frame_times.h"
#include "platform.h"
#include "serial_share.h"

#include <cstdint>
#include <string>
#include <vector>

namespace bench {

// What a child found when it had built its world.
struct Ready {
    std::string library;  // file of the libode.so.8 that it runs on
    bool isOurs = false;  // that library exports dToggleODE_MT
    std::string release = kUnknownRelease;  // of ODE, in that library
    int threads = 0;      // in force, of ours
    std::string manager, algorithm, callbacks;
    int gridCells = 0;  // 0: tuned
    std::size_t bodies = 0, joints = 0, geoms = 0;
    double stepSize = 0;                // s
    std::vector<std::string> warnings;  // what the loader ignored
};

struct Batch {
    int frames = 0;
    StageTimes seconds;
    FrameTimes frameTimes;
    std::uint64_t hash = 0;    // of the state after the last frame
    std::size_t contacts = 0;  // in the last frame
    unsigned messages = 0;     // of ODE, in this batch
    unsigned sharedSteps = 0;  // parallel steps of this batch, of our library
    SerialWork work;           // of our library, if it is asked for it
};

std::string writeReady(const Ready &ready);
std::string writeRequest(int frames);
std::string writeBatch(const Batch &batch);
std::string writeError(const std::string &what);

// Each throws std::runtime_error: with the child's own words if the line is an error of the child,
// else with the line that is invalid.
Ready readReady(const std::string &line);
int readRequest(const std::string &line);
Batch readBatch(const std::string &line);

std::string hashText(std::uint64_t hash);  // 16 hexadecimal digits

}  // namespace bench
