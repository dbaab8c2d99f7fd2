#include "top/signals.h"

#include <algorithm>

#include "deferred_signals.h"

namespace top {

namespace {

sigset_t deferred() {
    sigset_t set;
    sigemptyset(&set);
    for (const int signal : bench::kDeferredSignals) sigaddset(&set, signal);
    return set;
}

void ignoreNothing(int) {}

}  // namespace

void deferSignals() {
    // A signal that is ignored does not wait.
    struct sigaction action {};
    action.sa_handler = ignoreNothing;
    for (const int signal : bench::kDeferredSignals) sigaction(signal, &action, nullptr);
    const sigset_t set = deferred();
    sigprocmask(SIG_BLOCK, &set, nullptr);
}

int waitForSignal(std::chrono::milliseconds most) {
    const auto count = std::max<std::chrono::milliseconds::rep>(most.count(), 0);
    const timespec limit = {static_cast<time_t>(count / 1000), static_cast<long>(count % 1000 * 1'000'000)};
    const sigset_t set = deferred();
    const int signal = sigtimedwait(&set, nullptr, &limit);
    return signal > 0 ? signal : 0;
}

}  // namespace top
