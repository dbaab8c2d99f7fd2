// Plays frames in surroundings that are named, and prints what came of it:
//
//   odemt_surroundings NAME
//
// The first line names the library it runs on. Threads and algorithm come from the environment.
#include "surroundings.h"

#include <dlfcn.h>
#include <ode/ode.h>

#include <cstdio>
#include <cstring>

namespace {

using namespace faults;

constexpr struct {
    const char *name;
    std::uint64_t (*play)();
} kAll[] = {{"none", playFrames},
            {"signals", underSignals},
            {"small_stack", onSmallStack},
            {"stack_limit", withSmallStackLimit},
            {"address_space", withLittleAddressSpace},
            {"no_threads", withoutThreads},
            {"decimal_comma", withDecimalComma},
            {"busy_process", besideBusyProcess},
            {"many_threads", inManyThreads},
            {"coming_and_going", withWorldsComingAndGoing},
            {"others_initialise", whileOthersInitialise}};

}  // namespace

int main(int count, char **arguments) {
    if (count != 2) return 2;
    Dl_info library{};
    dladdr(reinterpret_cast<void *>(&dWorldStep), &library);
    std::printf("%s\n", library.dli_fname);
    for (const auto &one : kAll) {
        if (std::strcmp(one.name, arguments[1]) != 0) continue;
        dInitODE2(0);
        std::printf("%016llx\n", static_cast<unsigned long long>(one.play()));
        dCloseODE();
        return 0;
    }
    return 2;
}
