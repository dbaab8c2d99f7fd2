/* Upstream's stages share their items out by atomic counters, and lock the bus for each item. Ours never run on several
 * threads with one counter: a piece of a stage has counters of its own (ode_mt/dynamics/dxStagePieces.h). So they are
 * compiled as upstream compiles them without threads. */
#pragma once

#include "config.h"
#include "odeou.h"

#pragma push_macro("dTHREADING_INTF_DISABLED")
#undef dTHREADING_INTF_DISABLED
#define dTHREADING_INTF_DISABLED 1
#include "threadingutils.h"
#pragma pop_macro("dTHREADING_INTF_DISABLED")
