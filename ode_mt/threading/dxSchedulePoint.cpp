#include "threading/dxSchedulePoint.h"

namespace {

constexpr const char *kDescriptions[] = {
    "a run takes a slot of the job board",
    "a run is offered to the workers",
    "a worker takes a seat at a run",
    "a thread takes the next block of a run",
    "a thread of an OpenMP team takes the next block",
    "a run without workers goes on to its next block",
    "a thread reports blocks as finished",
    "the caller waits for the blocks of others",
    "a run is taken off the job board",
    "a run decides how many workers to wake",
    "a worker counts itself as parked",
    "a worker that has counted itself as parked finds work after all",
    "a parked worker takes up a wake-up",
    "a block is finished in its turn",
    "a block waits for those before it",
    "a thread takes a part of an island",
    "a thread tells how many rows of its part are done",
    "a part waits for rows of another part",
    "a phase of a job is opened to other threads",
    "a thread takes a chunk of such a phase",
    "the thread that opened it waits for the chunks of others",
    "a thread waits for the next phase",
    "a worker begins an island",
    "an island is interrupted, and later ones are taken back",
    "the islands' steps are made visible",
    "a step reserves its random numbers",
    "a second stepping thread waits for the first one's step",
    "a thread becomes the cleaner of a space",
    "a thread waits for the cleaner of a space",
    "a worker computes contacts of a pair ahead of its callback",
    "dCollide answers with contacts computed ahead",
    "a worker calls a callback that may run beside others",
    "joints made by such callbacks are put into their lists",
};
static_assert(sizeof kDescriptions / sizeof *kDescriptions == kSchedulePoints, "one sentence for each point");

}  // namespace

const char *dxDescribe(dxSchedulePoint point) { return kDescriptions[static_cast<unsigned>(point)]; }
