// libomp (clang).
//
// Idle threads: a thread spins for 200 ms after a region unless the blocktime is 0.
//
// End of threads: omp_pause_resource_all ends them, but the next region then aborts
// (libomp 14: "Thread identifier invalid"). So they stay, asleep, until the process ends.
//
// Fork: libomp has handlers of its own.
#include "threading/managers/dxOpenMPRuntime.h"

const char *dxOpenMPRuntime::fileName() { return "libomp.so.5"; }

void dxOpenMPRuntime::prepareRegions() const {
    if (m_setBlockTime != nullptr) m_setBlockTime(0);
}

bool dxOpenMPRuntime::endThreads() const { return false; }

bool dxOpenMPRuntime::prepareFork() const { return m_inParallel() == 0; }
