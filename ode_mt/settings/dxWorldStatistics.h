// Times and counts of the last frame of each world: dODE_MT_GetWorldStatistics, ODE_MT_LOG=info, odemt_top.
//
// A frame is a step and the collisions since the step before it. Times are those of the timeline's events (threading/timeline), summed up by
// stage; they are recorded while dxTimeline::isCounted(). A collision belongs to the world of the first body in its space. It is kept until
// the next step of that world, which may be on another thread.
//
// The statistics of a world are a part of its state (dxWorldState).
//
// Threading: any thread may call; one lock, held for moments. A world is not stepped by two threads at a time.
//
// Dropped: the world of each pair's bodies. Reading all bodies of a crowd takes as long as a part of its collision does.
#pragma once

#include <cstdint>

#include <ode/ode.h>

#include "threading/timeline/dxTimelineEvent.h"

struct dxCollisionRecord {
    std::uint64_t ticks = 0;  // dxTimelineClock
    dxFrameTimes times;       // set by the code that adds the record
    std::uint64_t pairs = 0, contactsAhead = 0, contactsAheadUsed = 0;
    unsigned threads = 1;
    dODE_MT_Reason reason = dODE_MT_REASON_PARALLEL, callbackReason = dODE_MT_REASON_PARALLEL;
};

// What workers in other processes (ODE_MT_WORKERS) did for a step.
struct dxRemoteRecord {
    unsigned workers = 0, lostWorkers = 0;  // of the process, at its end
    unsigned solved = 0, returned = 0;      // islands: solved by them; sent to them, and solved by this process after all
};

struct dxStepRecord {
    std::uint64_t begin = 0, end = 0;  // ticks
    dxFrameTimes times{};
    std::uint64_t rows = 0;
    unsigned threads = 1, threadsInForce = 0;  // that took part; that were allowed (dxOwnThreads)
    unsigned bodies = 0, contacts = 0, islands = 0;
    dODE_MT_Reason reason = dODE_MT_REASON_PARALLEL;
    dxRemoteRecord remote;
};

namespace dxWorldStatistics {

// Add a record. Without memory it is not counted.
void add(const dxWorld *world, const dxCollisionRecord &collision);
void add(const dxWorld *world, const dxStepRecord &step);

// Gives the world its number, if it has none yet. Called before worlds are stepped at the same time, so that they get theirs in order.
void enrol(const dxWorld *world);

// Reads the statistics of the last frame. Returns false if there is none; `statistics` is unchanged then.
bool read(const dxWorld *world, dODE_MT_WorldStatistics &statistics);

}  // namespace dxWorldStatistics
