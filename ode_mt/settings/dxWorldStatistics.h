// How the last frame of each world went: dODE_MT_GetWorldStatistics, ODE_MT_LOG=info, odemt_top.
//
// A frame is a step and the collisions since the step before it. Times are those of the timeline's events (threading/timeline), summed up by
// stage; they are recorded while dxTimeline::isCounted(). A collision is a world's if the first body in its space is. It is kept until
// that world's next step, which may be on another thread.
//
// What is counted is a part of the state of the world (dxWorldState). Threading: any thread may call; one lock, held for moments. The same world is
// not stepped twice at a time.
//
// Dropped: the world of each pair's bodies. To look at all bodies of a crowd takes as long as a part of its collision does.
#pragma once

#include <cstdint>

#include <ode/ode.h>

#include "threading/timeline/dxTimelineEvent.h"

struct dxCollisionRecord {
    std::uint64_t ticks = 0;  // dxTimelineClock
    dxFrameTimes times;       // set by whoever adds it
    std::uint64_t pairs = 0, contactsAhead = 0, contactsAheadUsed = 0;
    unsigned threads = 1;
    dODE_MT_Reason reason = dODE_MT_REASON_PARALLEL, callbackReason = dODE_MT_REASON_PARALLEL;
};

// Of a step: what workers in other processes (ODE_MT_WORKERS) did for it.
struct dxRemoteRecord {
    unsigned workers = 0, lostWorkers = 0;  // of the process, at its end
    unsigned solved = 0, returned = 0;      // islands: solved by them; sent to them, and solved by this process after all
};

struct dxStepRecord {
    std::uint64_t begin = 0, end = 0;  // ticks
    dxFrameTimes times{};
    std::uint64_t rows = 0;
    unsigned threads = 1, threadsInForce = 0;  // that took part; that might have (dxOwnThreads)
    unsigned bodies = 0, contacts = 0, islands = 0;
    dODE_MT_Reason reason = dODE_MT_REASON_PARALLEL;
    dxRemoteRecord remote;
};

namespace dxWorldStatistics {

// Without memory they are not counted.
void add(const dxWorld *world, const dxCollisionRecord &collision);
void add(const dxWorld *world, const dxStepRecord &step);

// Gives the world its number, if it has none yet: worlds that are about to be stepped at the same time get theirs in order.
void enrol(const dxWorld *world);

// Of the last frame. Returns false, and leaves them as they are, if there is none.
bool read(const dxWorld *world, dODE_MT_WorldStatistics &statistics);

}  // namespace dxWorldStatistics
