// libomp (clang).
//
// Idle threads: a thread spins for 200 ms after a region unless the blocktime is 0.
//
// End of threads: omp_pause_resource_all(omp_pause_hard) ends them, but the next region then aborts
// (libomp 14: "Thread identifier invalid"). So they stay, asleep, until the process ends.
//
// Fork: libomp has handlers of its own.
//
// Unloading: libomp may be unloaded, and its idle threads would then run into unmapped code. So it is
// kept in memory from the first region on.
#include <omp.h>

#include "threading/managers/dxOpenMPRuntime.h"
#include "threading/process/dxPinnedLibrary.h"
#include "threading/process/dxProcessObject.h"

namespace {

struct KeptInMemory {
    KeptInMemory() { dxPinLibraryOf(&omp_get_thread_num); }
};

dxProcessObject<KeptInMemory> keptInMemory;

}  // namespace

void dxOpenMPPrepareRegions() {
    *keptInMemory;
    kmp_set_blocktime(0);
}

bool dxOpenMPEndThreads() { return false; }

bool dxOpenMPPrepareFork() { return omp_in_parallel() == 0; }
