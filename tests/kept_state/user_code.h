// Places where ODE runs code of the program's, at which the call test makes its call: what was asked for with
// callIn() is done once, the next time that ODE runs that code.
#pragma once

#include <functional>

namespace kept_state {

enum class UserCode {
    colliderGetter,   // of a class of the program's
    collider,         // of a class of the program's
    boxFunction,      // of a class of the program's
    boxTest,          // of a class of the program's
    destructor,       // of a class of the program's
    triangleCallback, // of a mesh, also the one for rays
    heightCallback,   // of a height field
    messageHandler,
    debugHandler,
    allocator,        // ODE's own
    stepMemory        // a world's
};

void callIn(UserCode where, std::function<void()> call);
// Code of the program's calls this.
void reached(UserCode where);
// The call has not been made.
bool isCallWaiting();
void forgetCall();

}  // namespace kept_state
