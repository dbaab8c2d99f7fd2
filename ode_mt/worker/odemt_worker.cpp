// Solves islands for a program that another process runs, on this machine or another:
//
//   mpirun -np 1 PROGRAM : -np 15 odemt_worker        with ODE_MT_WORKERS=mpi in PROGRAM's environment
//
// It ends with the program, or when it has not heard of it for a minute.
#include <cstdio>
#include <cstring>

#include <ode/ode_MT.h>

#include "core/dxLog.h"
#include "dynamics/remote/dxPackedSolver.h"
#include "remote/dxRemoteServer.h"
#include "remote/mpi/dxMpiTransport.h"

namespace {

constexpr double kMaxSilence = 60;  // s; home is heard of every few seconds

int run() {
    std::string reason;
    const std::unique_ptr<dxMpiTransport> transport = dxMpiTransport::openWorker(reason);
    if (!transport) {
        std::fprintf(stderr, "odemt_worker: %s\n", reason.c_str());
        return 1;
    }
    dxRemoteServer server(*transport, dxDescribeSolver(), dxSolvePacked);
    const dxRemoteServer::End end = server.run(kMaxSilence);
    if (end == dxRemoteServer::End::Refused) std::fprintf(stderr, "odemt_worker: refused, since this worker %s\n", server.refusal().c_str());
    const bool isOrderly = end == dxRemoteServer::End::Orderly;
    transport->close(isOrderly);
    std::fflush(nullptr);
    if (!isOrderly) std::_Exit(0);  // MPI's own handlers would wait for the others
    return 0;
}

}  // namespace

int main(int count, char **arguments) {
    if (count == 2 && std::strcmp(arguments[1], "--version") == 0) {
        std::printf("odemt_worker %s\n", dODE_MT_VERSION);
        return 0;
    }
    if (count > 1) {
        std::fprintf(stderr, "odemt_worker: takes no arguments; usage: mpirun -np 1 PROGRAM : -np N odemt_worker\n");
        return 2;
    }
    return run();
}
