// Whether user code hears of errors, assertions or messages: it may look at the world in the middle of a step, or leave it.
#pragma once

#include <ode/error.h>

inline bool dxHasUserHandlers() {
    return dGetErrorHandler() != nullptr || dGetDebugHandler() != nullptr || dGetMessageHandler() != nullptr;
}
