/* Upstream's stages share their items out by atomic counters, and lock the bus for each item. Ours never run on several
 * threads with one counter: a piece of a stage has counters of its own (ode_mt/dynamics/dxStagePieces.h). So they are given
 * the counters that upstream has for builds without threads. All else that such builds do without stays, as QuickStep's
 * links and levels, whose memory is used (ode_mt/dynamics/dxIslandSweeps.h). */
#pragma once

#include "config.h"
#include "odeou.h"

#pragma push_macro("dTHREADING_INTF_DISABLED")
#undef dTHREADING_INTF_DISABLED
#define dTHREADING_INTF_DISABLED 1
#include "threadingutils.h"
#pragma pop_macro("dTHREADING_INTF_DISABLED")
