// Ctrl-C and the like: the run in progress ends, and what is known by then is told.
#pragma once

#include <csignal>

namespace check {

// From then on SIGINT, SIGTERM, SIGHUP, SIGQUIT and SIGCHLD arrive only while this process waits with waitingMask(). To be called once.
void deferSignals();
const sigset_t &waitingMask();

// Number of interrupts up to now.
int interrupts();

}  // namespace check
