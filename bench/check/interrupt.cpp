#include "check/interrupt.h"

#include "deferred_signals.h"

namespace check {

namespace {

volatile std::sig_atomic_t g_interrupts = 0;
sigset_t g_waitingMask;

void onInterrupt(int) { g_interrupts = g_interrupts + 1; }
void onChild(int) {}  // ends the wait

void handle(int signal, void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    sigaction(signal, &action, nullptr);
}

}  // namespace

void deferSignals() {
    sigset_t deferred;
    sigemptyset(&deferred);
    for (const int signal : bench::kEndingSignals) {
        handle(signal, onInterrupt);
        sigaddset(&deferred, signal);
    }
    handle(SIGCHLD, onChild);
    sigaddset(&deferred, SIGCHLD);
    sigprocmask(SIG_BLOCK, &deferred, &g_waitingMask);
    for (const int signal : bench::kDeferredSignals) sigdelset(&g_waitingMask, signal);
}

const sigset_t &waitingMask() { return g_waitingMask; }

int interrupts() { return g_interrupts; }

}  // namespace check
