// The functions that the observer stands in front of, as programs get them.
#pragma once

#include "ode_library.h"

namespace observer {

extern void *const kObservedCalls[kCalls];  // in the order of Call

}  // namespace observer
