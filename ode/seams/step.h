/* The exact step's LCP solver is ours (ode_mt/dynamics/lcp), and finds the workers of its island in the context of the
 * stage that calls it: same bits, less work (docs/lcp.md). */
#pragma once

#include "one_thread.h"

#include "dynamics/dxIslandCall.h"
#include "dynamics/lcp/dxDantzig.h"
#include "dynamics/lcp/dxUpstreamLcp.h"

#define dxSolveLCP(...) dxSolveDantzig(dxIslandCall::of(callContext).team, __VA_ARGS__)
