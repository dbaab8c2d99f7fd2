#include <ode/ode.h>

#include <algorithm>
#include <thread>
#include <vector>

#include "surroundings.h"

namespace faults {

std::uint64_t inManyThreads() {
    constexpr unsigned kThreads = 64;
    std::vector<std::uint64_t> hashes(kThreads);
    std::vector<std::thread> threads;
    for (std::uint64_t &hash : hashes)
        threads.emplace_back([&hash] {
            dAllocateODEDataForThread(dAllocateMaskAll);
            hash = playFrames();
            dCleanupODEAllDataForThread();
        });
    for (std::thread &thread : threads) thread.join();
    const bool areEqual =
        std::all_of(hashes.begin(), hashes.end(), [&](std::uint64_t hash) { return hash == hashes[0]; });
    return areEqual ? hashes[0] : 0;
}

}  // namespace faults
