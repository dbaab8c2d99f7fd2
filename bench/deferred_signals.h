// Signals that tools which run programs take when they are ready for them: those that ask a process to end, and the end of a child.
#pragma once

#include <csignal>

namespace bench {

constexpr int kEndingSignals[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};
constexpr int kDeferredSignals[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGCHLD};

}  // namespace bench
