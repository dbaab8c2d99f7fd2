// A program that uses MPI itself, with workers of ODE_MT's besides:
//
//   ODE_MT_WORKERS=mpi:1 ODE_MT_ALGORITHM=lcp odemt_own_mpi close|leave|finalise
//
// dCloseODE comes before MPI_Finalize, never, or after it. Prints the state of its chains after their steps, half of which come after the end of MPI
// in the last case; "the end" is the last line.
#include <mpi.h>
#include <ode/ode.h>

#include <cstdio>
#include <string>

#include "ChainWorld.h"

namespace {

constexpr unsigned kChains = 8, kLinks = 20, kSteps = 20;

void run(bool isMpiEndedFirst) {
    ChainWorld chains(kChains, kLinks, dWorldStep);
    chains.step(kSteps / 2);
    if (isMpiEndedFirst) MPI_Finalize();
    chains.step(kSteps / 2);
    for (const dReal number : chains.state()) std::printf("%.17g\n", static_cast<double>(number));
}

}  // namespace

int main(int count, char **arguments) {
    int level = 0;
    MPI_Init_thread(&count, &arguments, MPI_THREAD_MULTIPLE, &level);
    if (count != 2 || level != MPI_THREAD_MULTIPLE) return 2;
    const std::string order = arguments[1];
    const bool isMpiEndedFirst = order == "finalise";
    dInitODE2(0);
    run(isMpiEndedFirst);
    if (order != "leave") dCloseODE();
    if (!isMpiEndedFirst) MPI_Finalize();
    std::printf("the end\n");
    return 0;
}
