// Functions of ode/error.h, in place of upstream's error.cpp: errors, debug errors and messages.
//
// Same texts, same streams, same ends of the process. The difference: a call made by an island that is
// being stepped goes to that island's scope first, which may keep it until dxIslandParallelStep delivers it on the
// thread that called the step, in upstream's order (contract C4).
//
// The three handlers are process-wide because ODE's API is. They are atomics, so that installing one
// while another thread steps is no data race.
#include <ode/error.h>

#include <atomic>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>

#include "collision/pairs/dxUnnoticedChanges.h"
#include "dynamics/step/random/dxSingleStepper.h"
#include "threading/dxUpstreamScope.h"

namespace {

struct Channel {
    const char *title;
    std::atomic<dMessageFunction *> handler{nullptr};
};

Channel g_error{"ODE Error"};
Channel g_debug{"ODE INTERNAL ERROR"};
Channel g_message{"ODE Message"};

void printToStderr(const char *title, int number, const char *format, va_list arguments) {
    std::fflush(stderr);
    std::fflush(stdout);
    std::fprintf(stderr, number != 0 ? "\n%s %d: " : "\n%s: ", title, number);
    std::vfprintf(stderr, format, arguments);
    std::fputc('\n', stderr);
    std::fflush(stderr);
}

bool takenOver(dxReport kind, int number, const char *format, va_list arguments) {
    dxUpstreamScope *scope = dxUpstreamScope::current();
    return scope != nullptr && scope->takeOver(kind, number, format, arguments);
}

void report(Channel &channel, int number, const char *format, va_list arguments) {
    if (dMessageFunction *handler = channel.handler.load()) {
        const dxSingleStepper::UserCode userCode;
        handler(number, format, arguments);
    } else {
        printToStderr(channel.title, number, format, arguments);
    }
}

// A handler that does not return leaves whatever was being done half done.
void reportFault(Channel &channel, int number, const char *format, va_list arguments) {
    dxMissedNotifications.add();
    report(channel, number, format, arguments);
}

}  // namespace

extern "C" {

void dSetErrorHandler(dMessageFunction *handler) { g_error.handler = handler; }
void dSetDebugHandler(dMessageFunction *handler) { g_debug.handler = handler; }
void dSetMessageHandler(dMessageFunction *handler) { g_message.handler = handler; }

dMessageFunction *dGetErrorHandler() { return g_error.handler; }
dMessageFunction *dGetDebugHandler() { return g_debug.handler; }
dMessageFunction *dGetMessageHandler() { return g_message.handler; }

void dError(int number, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    takenOver(dxReport::Error, number, format, arguments);
    reportFault(g_error, number, format, arguments);
    va_end(arguments);
    const dxSingleStepper::UserCode userCode;  // what the program has registered with atexit
    std::exit(1);
}

void dDebug(int number, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    takenOver(dxReport::Debug, number, format, arguments);
    reportFault(g_debug, number, format, arguments);
    va_end(arguments);
    std::abort();
}

void dMessage(int number, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    if (!takenOver(dxReport::Message, number, format, arguments)) {
        report(g_message, number, format, arguments);
    }
    va_end(arguments);
}

}  // extern "C"
