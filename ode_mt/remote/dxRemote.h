// Workers in other processes, as exported functions see them (ODE_MT_WORKERS, docs/remote.md). Steps reach them by dxRemoteSolvers.
//
//   transport/      messages, and what carries them: MPI in mpi/
//   coordinator/    this process's side: links to workers, batches of problems, the communication thread
//   islands/        islands as problems
//   worker/         odemt_worker
//
// Threading: any thread.
#pragma once

#include <ode/ode_MT.h>

namespace dxRemote {

// Connects to the workers that the settings name, if they name any. Once in a process.
void open();

// Ends the workers.
void close();

// dODE_MT_GetRemoteStatistics; the size is the caller's.
dODE_MT_RemoteStatistics statistics();

}  // namespace dxRemote
