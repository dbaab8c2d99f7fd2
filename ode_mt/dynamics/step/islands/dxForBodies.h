// The loops over the bodies of an island that its stages have: on the calling thread in the island's order, or on the island's workers in any order.
//
// In an island that does not fit L2 the next bodies and joints are prefetched. An island's order follows its joints from body to body; in a heap that
// order is random in memory.
#pragma once

#include <algorithm>
#include <cstddef>

#include "config.h"
#include "objects.h"
#include "joints/contact.h"

#include "core/dxPrefetch.h"
#include "dynamics/step/islands/dxIslandStep.h"

namespace dxIslandPrefetch {

// Number of bodies from which on a stage prefetches: a hundred bodies with their contacts are half a megabyte.
constexpr unsigned kMinBodies = 100;

constexpr std::size_t kDistance = 4;  // prefetch distance, and size of a chunk

// Prefetches what stages read of a body: all but the settings of automatic disabling and damping at its end.
inline void body(const dxBody *body) {
    const auto begin = reinterpret_cast<const char *>(body), end = reinterpret_cast<const char *>(&body->finite_rot_axis);
    dxPrefetch::linesForWrite(begin, static_cast<std::size_t>(end - begin));
}

// Prefetches a joint of any kind, by the size of a contact, the most frequent kind.
inline void joint(const dxJoint *joint) { dxPrefetch::lines(joint, sizeof(dxJointContact)); }

// Calls work(begin, end) for chunks of [begin, end) of at most kDistance items, after fetch(item) for those of the next
// chunk, which may be beyond `end` but below `count`.
template <class Prefetch, class Work>
void forChunks(std::size_t begin, std::size_t end, std::size_t count, const Prefetch &prefetch, const Work &work) {
    for (std::size_t chunk = begin; chunk < end; chunk += kDistance) {
        const std::size_t next = std::min(chunk + kDistance, count);
        for (std::size_t i = next; i < std::min(next + kDistance, count); ++i) prefetch(i);
        work(chunk, std::min(chunk + kDistance, end));
    }
}

}  // namespace dxIslandPrefetch

namespace dxBodyLoops {

// Bodies that one worker takes at once: some ten microseconds.
constexpr std::size_t kBodiesPerJob = 32;

// Calls work(i) for the bodies [begin, end). Bodies are prefetched up to number `fetchEnd`.
template <class Work>
void forRange(const dxIslandStep &step, std::size_t begin, std::size_t end, std::size_t fetchEnd, const Work &work) {
    if (step.island.bodyCount < dxIslandPrefetch::kMinBodies) {
        for (std::size_t i = begin; i < end; ++i) work(i);
        return;
    }
    dxBody *const *const bodies = step.island.bodies;
    dxIslandPrefetch::forChunks(begin, end, fetchEnd, [bodies](std::size_t i) { dxIslandPrefetch::body(bodies[i]); },
                                [&work](std::size_t first, std::size_t last) {
                                    for (std::size_t i = first; i < last; ++i) work(i);
                                });
}

}  // namespace dxBodyLoops

// Calls work(number) for all bodies in the island's order.
template <class Work>
void dxForBodies(const dxIslandStep &step, const Work &work) {
    dxBodyLoops::forRange(step, 0, step.island.bodyCount, step.island.bodyCount, work);
}

// Calls work(number) for all bodies, on the island's workers. What lies beyond a job may be another worker's and is not fetched.
template <class Work>
void dxForBodiesInParallel(const dxIslandStep &step, dxParallelStage stage, const Work &work) {
    if (step.islandWorkers == nullptr) return dxForBodies(step, work);
    step.runner().forChunks(stage, step.island.bodyCount, dxBodyLoops::kBodiesPerJob,
                            [&](std::size_t begin, std::size_t end, unsigned) {
                                dxBodyLoops::forRange(step, begin, end, end, work);
                            });
}
