// Refuses memory to one frame, request by request, each in a process of its own, and prints what followed:
//
//   odemt_allocation_faults SPACE STEPPER TOWERS EVERY [--show PHASE SOURCE SHORTAGE NUMBER]
//
// Prints the library it runs on, "reference HASH", and then a line "PHASE SOURCE SHORTAGE NUMBER OUTCOME" for each, where
// NUMBER is that of the first request that failed. STEPPER: world, quick, or either with one large island: heap (quick), world_heap.
// EVERY: each how manieth request. --show: only that request, and the stack that asked. Threads and algorithm come from the
// environment.
#include "failing_memory.h"
#include "fault_world.h"

#include <dlfcn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace {

using namespace faults;

constexpr int kWarmFrames = 4, kFramesAfter = 3;
// Requests of several threads come in another order each time, so that a number may not be reached though a
// later one is.
constexpr int kMaxNotReached = 3;
constexpr unsigned kPatience = 20;  // seconds
constexpr long kMaxShown = 1000000;

struct Case {
    const char *phase;
    Source source;
    Shortage shortage;
};

const char *nameOf(Source source) {
    switch (source) {
        case Source::operatorNew:
            return "new";
        case Source::malloc:
            return "malloc";
        default:
            return "allocator";
    }
}
const char *nameOf(Shortage shortage) { return shortage == Shortage::once ? "once" : "lasting"; }

void play(FaultWorld &world, int frames) {
    for (int i = 0; i < frames; ++i) world.frame();
}

// Exit codes of a forked child, in which the frame with the refusals runs.
enum Status { kAsReference, kAsReferenceAfterRefusal, kDiffers, kNotReached };

[[noreturn]] void playInChild(FaultWorld &world, const Case &c, long number, std::uint64_t reference) {
    const rlimit noCore{0, 0};
    setrlimit(RLIMIT_CORE, &noCore);
    alarm(kPatience);
    arm(c.source, number, c.shortage);
    const int refusals = world.frame([] { disarm(); });
    const bool isReached = disarm() > number || refusals > 0;
    play(world, kFramesAfter);
    world.useSpace();
    const bool isSame = world.hash() == reference;
    _exit(!isSame        ? kDiffers
          : !isReached   ? kNotReached
          : refusals > 0 ? kAsReferenceAfterRefusal
                         : kAsReference);
}

std::string endingOf(int status) {
    if (WIFSIGNALED(status))
        return WTERMSIG(status) == SIGALRM ? "hangs" : "signal " + std::to_string(WTERMSIG(status));
    switch (WEXITSTATUS(status)) {
        case kAsReference:
            return "goes on";
        case kAsReferenceAfterRefusal:
            return "refused, goes on";
        case kDiffers:
            return "differs";
        case kNotReached:
            return "not reached";
        default:
            return "status " + std::to_string(WEXITSTATUS(status));
    }
}

// The only case that is played, if there is one, as its line begins.
std::string shown;

std::string outcomeOf(FaultWorld &world, const Case &c, long number, std::uint64_t reference) {
    const pid_t child = fork();
    if (child == 0) {
        if (!shown.empty()) showFirstRefusal();
        playInChild(world, c, number, reference);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return endingOf(status);
}

std::string nameOf(const Case &c, long number) {
    return std::string(c.phase) + ' ' + nameOf(c.source) + ' ' + nameOf(c.shortage) + ' ' +
           std::to_string(number);
}

void refuseOneByOne(FaultWorld &world, const Case &c, std::uint64_t reference, long every) {
    int notReached = 0;
    for (long number = 0; notReached < kMaxNotReached; number += every) {
        const std::string name = nameOf(c, number);
        if (!shown.empty() && shown != name) {
            if (number > kMaxShown) return;
            continue;
        }
        const std::string outcome = outcomeOf(world, c, number, reference);
        if (outcome == "not reached")
            ++notReached;
        else
            notReached = 0;
        std::printf("%s %s\n", name.c_str(), outcome.c_str());
        std::fflush(stdout);
    }
}

// What the same frames give when nothing is refused. In a child, for worlds do not change each other's random
// sequence.
std::uint64_t referenceOf(FaultWorld &world) {
    int ends[2];
    if (pipe(ends) != 0) std::abort();
    const pid_t child = fork();
    if (child == 0) {
        play(world, 1 + kFramesAfter);
        const std::uint64_t hash = world.hash();
        _exit(write(ends[1], &hash, sizeof hash) == sizeof hash ? 0 : 1);
    }
    std::uint64_t hash = 0;
    if (read(ends[0], &hash, sizeof hash) != sizeof hash) std::abort();
    close(ends[0]);
    close(ends[1]);
    waitpid(child, nullptr, 0);
    return hash;
}

void refuseAll(FaultWorld &world, const char *phase, long every) {
    const std::uint64_t reference = referenceOf(world);
    std::printf("reference %016llx\n", static_cast<unsigned long long>(reference));
    std::fflush(stdout);
    for (const Source source : {Source::operatorNew, Source::malloc, Source::allocator})
        for (const Shortage shortage : {Shortage::once, Shortage::lasting})
            refuseOneByOne(world, {phase, source, shortage}, reference, every);
}

SpaceKind spaceOf(const std::string &name) {
    if (name == "simple") return SpaceKind::simple;
    if (name == "hash") return SpaceKind::hash;
    return name == "sap" ? SpaceKind::sweepAndPrune : SpaceKind::quadTree;
}

}  // namespace

int main(int count, char **arguments) {
    if (count == 10)
        for (int i = 6; i < 10; ++i) shown += (i > 6 ? " " : "") + std::string(arguments[i]);
    else if (count != 5)
        return 2;
    Dl_info library{};
    dladdr(reinterpret_cast<void *>(&dWorldStep), &library);
    std::printf("%s\n", library.dli_fname);
    const std::string stepper = arguments[2];
    dInitODE2(0);
    {
        const bool isExact = stepper == "world" || stepper == "world_heap", isHeap = stepper == "heap" || stepper == "world_heap";
        FaultWorld world(spaceOf(arguments[1]), isExact ? dWorldStep : dWorldQuickStep, std::atoi(arguments[3]), isHeap);
        const long every = std::atol(arguments[4]);
        refuseAll(world, "cold", every);
        play(world, kWarmFrames);
        refuseAll(world, "warm", every);
    }
    dCloseODE();
    return 0;
}
