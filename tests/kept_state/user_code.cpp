#include "user_code.h"

#include <utility>

namespace kept_state {

namespace {

UserCode wanted;
std::function<void()> waitingCall;

}  // namespace

void callIn(UserCode where, std::function<void()> call) {
    wanted = where;
    waitingCall = std::move(call);
}

void reached(UserCode where) {
    if (!waitingCall || where != wanted) return;
    // Code of the program's may run within the call.
    const std::function<void()> call = std::exchange(waitingCall, nullptr);
    call();
}

bool isCallWaiting() { return static_cast<bool>(waitingCall); }
void forgetCall() { waitingCall = nullptr; }

}  // namespace kept_state
