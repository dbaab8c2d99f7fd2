#include <ode/ode.h>

#include <atomic>
#include <thread>

#include "surroundings.h"

namespace faults {

// The library counts: it is closed for good by the last one only, and workers that are busy for this thread
// stay.
std::uint64_t whileOthersInitialise() {
    std::atomic<bool> isDone{false};
    std::thread other([&isDone] {
        while (!isDone.load()) {
            dInitODE2(0);
            dCloseODE();
        }
    });
    std::uint64_t hash = playFrames();
    for (int i = 0; i < 4; ++i)
        if (playFrames() != hash) hash = 0;
    isDone = true;
    other.join();
    return hash;
}

}  // namespace faults
