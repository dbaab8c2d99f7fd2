#include "support/deferred_signals.h"

#include <sys/signalfd.h>

#include <algorithm>
#include <csignal>
#include <ctime>

namespace support {

namespace {

constexpr int kDeferred[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGCHLD};

sigset_t deferred() {
    sigset_t set;
    sigemptyset(&set);
    for (const int signal : kDeferred) sigaddset(&set, signal);
    return set;
}

void doNothing(int) {}

}  // namespace

void deferSignals() {
    // A signal that is ignored does not wait.
    struct sigaction action {};
    action.sa_handler = doNothing;
    for (const int signal : kDeferred) sigaction(signal, &action, nullptr);
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

Descriptor signalFile() {
    const sigset_t set = deferred();
    return Descriptor(signalfd(-1, &set, SFD_CLOEXEC | SFD_NONBLOCK));
}

}  // namespace support
