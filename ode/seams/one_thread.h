/* The stages of upstream's exact step count their items by atomic counters, and lock the bus for each item. Here a stage runs on one
 * thread, so they are given the counters that upstream has for builds without threads. */
#pragma once

#include "config.h"
#include "odeou.h"

#pragma push_macro("dTHREADING_INTF_DISABLED")
#undef dTHREADING_INTF_DISABLED
#define dTHREADING_INTF_DISABLED 1
#include "threadingutils.h"
#pragma pop_macro("dTHREADING_INTF_DISABLED")
