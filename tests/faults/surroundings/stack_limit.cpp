#include <sys/resource.h>
#include <unistd.h>

#include "surroundings.h"

namespace faults {

// Sets the limit of `ulimit -s 256`. The C library reads the limit when a process starts, so this one is executed again.
std::uint64_t withSmallStackLimit() {
    constexpr rlim_t kStack = 256 << 10;
    rlimit limit{};
    getrlimit(RLIMIT_STACK, &limit);
    if (limit.rlim_cur != kStack) {
        limit.rlim_cur = kStack;
        if (setrlimit(RLIMIT_STACK, &limit) != 0) return 0;
        execl("/proc/self/exe", "odemt_surroundings", "stack_limit", static_cast<char *>(nullptr));
        return 0;
    }
    return playFrames();
}

}  // namespace faults
