// dWorldSetSteppingThreadingParameters, which came with ODE 0.16.6 (objects.h).
#include <ode/objects.h>

#include <new>

#include "seams/upstream.h"
#include "settings/dxWorldState.h"

extern "C" {

// The limit for solving is one thread until the program sets another, since upstream's own solver is slower on several. That is no
// reason for ours: it is bound by what the program has set, which is noted beside the world.
void dWorldSetSteppingThreadingParameters(dWorldID world, const dWorldSteppingThreadingParameters *parameters) {
    dxUpstreamWorldSetSteppingThreadingParameters(world, parameters);
    if ((parameters->param_set & dWSTP_LCPSolvingMaxThreads) == 0) return;
    try {
        dxSetSolvingLimit(world, parameters->lcp_solving_max_threads);
    } catch (const std::bad_alloc &) {
        dMessage(0, "ODE_MT: no memory to note the limit of threads that solve an island of a world");
    }
}

}  // extern "C"
