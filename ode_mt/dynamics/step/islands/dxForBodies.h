// The loops over the bodies of an island that its stages have: on the calling thread in the island's order, or on the island's
// workers in any order. In an island that does not fit L2 the next bodies are prefetched.
#pragma once

#include <cstddef>

#include "dynamics/step/islands/dxIslandPrefetch.h"
#include "dynamics/step/islands/dxIslandStep.h"

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
