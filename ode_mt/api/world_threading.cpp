// Calls after which a world's threading implementation may be freed: its threads must have left this
// library by then.
#include <ode/objects.h>

#include "frame/dxWorldWorkers.h"

extern "C" {

// Upstream's own, renamed by the seam ode/seams/ode.h.
void dxUpstreamWorldSetStepThreadingImplementation(dWorldID world, const dThreadingFunctionsInfo *functions,
                                                   dThreadingImplementationID implementation);
void dxUpstreamWorldDestroy(dWorldID world);

void dWorldSetStepThreadingImplementation(dWorldID world, const dThreadingFunctionsInfo *functions,
                                          dThreadingImplementationID implementation) {
    if (world != nullptr) dxWorldWorkers::giveBack(world);
    dxUpstreamWorldSetStepThreadingImplementation(world, functions, implementation);
}

void dWorldDestroy(dWorldID world) {
    if (world != nullptr) dxWorldWorkers::giveBack(world);
    dxUpstreamWorldDestroy(world);
}

}  // extern "C"
