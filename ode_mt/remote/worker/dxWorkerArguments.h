// The options of odemt_worker, on its command line or, where another program starts it, in the variable ODEMT_WORKER_ARGUMENTS.
//
// Threading: one thread.
#pragma once

#include <string>
#include <vector>

#include "remote/worker/dxSimulatedNetwork.h"

struct dxWorkerArguments {
    dxSimulatedLink link;
    std::string record;  // file for dxWorkRecord; empty: none

    static constexpr const char *kHelp =
        "  --delay TIME       what the coordinator and this worker send arrives so much later: 50us, 1ms\n"
        "  --bandwidth RATE   and takes bytes / RATE: 117MB/s, 1Gbit/s\n"
        "  --record FILE      a line for each problem is appended: step, number, bodies, joints, rows, bytes, ns, bytes of the result\n";
};

// Returns the words of the variable.
std::vector<std::string> dxWorkerArgumentsOfEnvironment();

// Reads options. Returns what is wrong; empty: nothing.
std::string dxReadWorkerArguments(const std::vector<std::string> &words, dxWorkerArguments &arguments);
