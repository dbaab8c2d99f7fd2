// libode_mt_loopback.so: ODE_MT_WORKERS=loopback:n makes n workers that are threads of the process, with a solver of their own in this library.
// For tests of programs that are not recompiled, also under sanitizers that do not bear MPI.
#include <algorithm>
#include <cstdio>

#include "dynamics/remote/dxPackedSolver.h"
#include "loopback_transport.h"

extern "C" __attribute__((visibility("default"))) dxRemoteTransport *dxOpenRemoteTransport(unsigned interfaceVersion, unsigned wanted, char *reason,
                                                                                         std::size_t reasonSize) {
    if (interfaceVersion == dxRemoteTransport::kInterfaceVersion)
        return new LoopbackTransport(std::max(wanted, 1u), dxDescribeSolver(), dxSolvePacked);
    std::snprintf(reason, reasonSize, "libode_mt_loopback.so is of another version than the library");
    return nullptr;
}
