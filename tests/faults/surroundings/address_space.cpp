#include <sys/resource.h>
#include <unistd.h>

#include <fstream>

#include "surroundings.h"

namespace faults {

// Sets the limit of `ulimit -v`. A worker's stack alone takes 8 MB.
std::uint64_t withLittleAddressSpace() {
    constexpr rlim_t kMore = 24 << 20;
    rlim_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const rlim_t most = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + kMore;
    const rlimit limit{most, most};
    if (setrlimit(RLIMIT_AS, &limit) != 0) return 0;
    return playFrames();
}

}  // namespace faults
