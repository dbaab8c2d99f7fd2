// Solves islands for a program that another process runs, on this machine or another:
//
//   mpirun -np 1 PROGRAM : -np 15 odemt_worker        with ODE_MT_WORKERS=mpi in PROGRAM's environment
//
// It ends with the program, or when it has received nothing for a minute. The options (--help) are for measurements: a slower network, a record.
#include <malloc.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include <ode/ode_MT.h>

#include "core/dxLog.h"
#include "remote/islands/dxPackedSolver.h"
#include "remote/worker/dxRemoteServer.h"
#include "remote/mpi/dxMpiTransport.h"
#include "remote/worker/dxSimulatedNetwork.h"
#include "remote/worker/dxWorkRecord.h"
#include "remote/worker/dxWorkerArguments.h"

namespace {

constexpr double kMaxSilence = 60;  // s; the coordinator sends a sign of life every few seconds

std::unique_ptr<dxRemoteTransport> openTransport(const dxSimulatedLink &link, dxSimulatedNetwork *&network, std::string &reason) {
    const auto openMpi = [](std::string &why) -> std::unique_ptr<dxRemoteTransport> { return dxMpiTransport::openWorker(why); };
    if (!link.isThere()) return openMpi(reason);
    std::unique_ptr<dxSimulatedNetwork> opened = dxSimulatedNetwork::open(link, openMpi, reason);
    network = opened.get();
    return opened;
}

// Messages come and go: memory that is given back to the system after each costs more than all else that is done to it (dxSpareBytes.h).
void keepFreedMemory() {
    constexpr int kMostMapped = 32 << 20, kMostKept = 64 << 20;  // bytes
    mallopt(M_MMAP_THRESHOLD, kMostMapped);
    mallopt(M_TRIM_THRESHOLD, kMostKept);
}

int run(const dxWorkerArguments &arguments) {
    std::string reason;
    dxSimulatedNetwork *network = nullptr;
    const std::unique_ptr<dxRemoteTransport> transport = openTransport(arguments.link, network, reason);
    std::unique_ptr<dxWorkRecord> record;
    if (transport && !arguments.record.empty()) {
        record = dxWorkRecord::open(arguments.record, *transport, reason);
        if (!record) transport->close(false);
    }
    if (!transport || (!arguments.record.empty() && !record)) {
        std::fprintf(stderr, "odemt_worker: %s\n", reason.c_str());
        return 1;
    }
    dxRemoteServer::Solve solve = dxSolvePacked;
    if (record) solve = record->timed(std::move(solve));
    if (network != nullptr) solve = network->carrying(std::move(solve));
    dxRemoteTransport &used = record ? *record : *transport;
    dxRemoteServer server(used, dxDescribeSolver(), std::move(solve));
    const dxRemoteServer::End end = server.run(kMaxSilence);
    if (end == dxRemoteServer::End::NoMemory) std::fprintf(stderr, "odemt_worker: no memory; it ends\n");
    if (end == dxRemoteServer::End::Refused) std::fprintf(stderr, "odemt_worker: refused, since this worker %s\n", server.refusal().c_str());
    const bool isOrderly = end == dxRemoteServer::End::Orderly;
    used.close(isOrderly);
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
    if (count == 2 && std::strcmp(arguments[1], "--help") == 0) {
        std::printf("usage: mpirun -np 1 PROGRAM : -np N odemt_worker [OPTIONS]\n%s", dxWorkerArguments::kHelp);
        return 0;
    }
    std::vector<std::string> words = dxWorkerArgumentsOfEnvironment();
    words.insert(words.end(), arguments + 1, arguments + count);
    dxWorkerArguments read;
    const std::string complaint = dxReadWorkerArguments(words, read);
    if (!complaint.empty()) {
        std::fprintf(stderr, "odemt_worker: %s; --help lists the options\n", complaint.c_str());
        return 2;
    }
    keepFreedMemory();
    try {
        return run(read);
    } catch (const std::bad_alloc &) {
        std::fprintf(stderr, "odemt_worker: no memory; it ends\n");
        std::_Exit(1);  // MPI's own handlers would wait for the others
    }
}
