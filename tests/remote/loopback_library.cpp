// libode_mt_loopback.so: ODE_MT_WORKERS=loopback:n makes n workers that are threads of the process, with a solver of their own in this library.
// For tests of programs that are not recompiled, also under sanitizers that do not bear MPI. ODEMT_WORKER_ARGUMENTS is as for odemt_worker.
#include <algorithm>
#include <cstdio>
#include <string>

#include "remote/islands/dxPackedSolver.h"
#include "loopback_transport.h"

extern "C" __attribute__((visibility("default"))) dxRemoteTransport *dxOpenRemoteTransport(unsigned interfaceVersion, unsigned wanted, char *reason,
                                                                                         std::size_t reasonSize) {
    std::string why = "libode_mt_loopback.so is of another version than the library";
    if (interfaceVersion == dxRemoteTransport::kInterfaceVersion) {
        dxWorkerArguments arguments;
        why = dxReadWorkerArguments(dxWorkerArgumentsOfEnvironment(), arguments);
        if (why.empty()) return new LoopbackTransport(std::max(wanted, 1u), dxDescribeSolver(), dxSolvePacked, nullptr, arguments);
    }
    std::snprintf(reason, reasonSize, "%s", why.c_str());
    return nullptr;
}
