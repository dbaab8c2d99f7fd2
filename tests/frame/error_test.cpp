// dError, dDebug and dMessage: the same texts and the same end of the process as with Debian's library.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <csetjmp>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>

#include "support/child_run.h"
#include "DebianOde.h"

namespace {

using Report = void(int, const char *, ...);

struct Call {
    const char *name;
    Report *report;
    decltype(dSetErrorHandler) *setHandler;
    decltype(dGetErrorHandler) *getHandler;
    const char *setHandlerName;
};

// The addresses are not constant expressions of a shared library, so this is a function.
std::vector<Call> calls() {
    return {{"dError", dError, dSetErrorHandler, dGetErrorHandler, "dSetErrorHandler"},
            {"dDebug", dDebug, dSetDebugHandler, dGetDebugHandler, "dSetDebugHandler"},
            {"dMessage", dMessage, dSetMessageHandler, dGetMessageHandler, "dSetMessageHandler"}};
}

void expectSame(const support::Ending &own, const support::Ending &debian) {
    EXPECT_EQ(own.errors, debian.errors);
    EXPECT_EQ(own.status, debian.status);
}

std::string g_heard;

void hear(int number, const char *format, va_list arguments) {
    char text[200];
    std::vsnprintf(text, sizeof text, format, arguments);
    g_heard = std::to_string(number) + ": " + text;
    std::fprintf(stderr, "heard %d: %s", number, text);
}

TEST(Error, DefaultTextAndEndAreDebians) {
    for (const Call &call : calls()) {
        Report *const debian = debianOde::function(call.report, call.name);
        for (const int number : {0, 7, -3}) {
            SCOPED_TRACE(call.name + std::string(" ") + std::to_string(number));
            const auto speak = [number](Report *report) {
                return support::runInChild([=] { report(number, "%d boxes fell %s\n", 3, "down"); });
            };
            expectSame(speak(call.report), speak(debian));
        }
    }
}

// Numbers are for what upstream tells apart.
TEST(Error, MessagesOfOurOwnHaveNoNumber) {
    dSetMessageHandler(&hear);
    const std::pair<const char *, int (*)(const char *)> setters[] = {
        {"algorithm", dODE_MT_SetAlgorithm}, {"callback policy", dODE_MT_SetCallbackPolicy},
        {"heuristic", dODE_MT_SetHeuristics}, {"thread manager", dODE_MT_SetThreadManager}};
    for (const auto &[what, set] : setters) {
        testing::internal::CaptureStderr();
        g_heard.clear();
        EXPECT_EQ(set("none of these"), 0) << what;
        EXPECT_EQ(g_heard.find("0: ODE_MT: "), 0u) << what << ": " << g_heard;
        testing::internal::GetCapturedStderr();
    }
    dSetMessageHandler(nullptr);
}

// So that the comparison above is of something.
TEST(Error, DefaultTextNamesTheNumber) {
    EXPECT_EQ(support::runInChild([] { dMessage(7, "hello"); }).errors, "\nODE Message 7: hello\n");
    EXPECT_TRUE(support::runInChild([] { dError(0, "hello"); }).exitedWith(1));
    EXPECT_TRUE(support::runInChild([] { dDebug(0, "hello"); }).killedBy(SIGABRT));
}

TEST(Error, HandlerIsCalledAndTheProcessEndsAsWithDebian) {
    for (const Call &call : calls()) {
        SCOPED_TRACE(call.name);
        const auto speak = [](Report *report, auto *setHandler) {
            return support::runInChild([=] {
                setHandler(hear);
                report(5, "%s", "text");
            });
        };
        const support::Ending own = speak(call.report, call.setHandler);
        EXPECT_NE(own.errors.find("heard 5: text"), std::string::npos);
        expectSame(own, speak(debianOde::function(call.report, call.name),
                              debianOde::function(call.setHandler, call.setHandlerName)));
    }
}

TEST(Error, HandlersAreReadBackAndRemoved) {
    for (const Call &call : calls()) {
        EXPECT_EQ(call.getHandler(), nullptr) << call.name;
        call.setHandler(hear);
        for (const Call &other : calls()) EXPECT_EQ(other.getHandler() == hear, other.name == call.name);
        call.setHandler(nullptr);
        EXPECT_EQ(call.getHandler(), nullptr) << call.name;
    }
}

TEST(Error, HandlerMayLeaveWithLongjmp) {
    static std::jmp_buf place;
    dSetDebugHandler([](int number, const char *, va_list) { std::longjmp(place, number); });
    const int number = setjmp(place);
    if (number == 0) dDebug(42, "never returns");
    EXPECT_EQ(number, 42);
    dSetDebugHandler(nullptr);
}

TEST(Error, HandlerMayThrow) {
    dSetErrorHandler([](int number, const char *, va_list) { throw number; });
    EXPECT_THROW(dError(1, "thrown"), int);
    dSetErrorHandler(nullptr);
}

TEST(Error, MessageWithAHandlerPrintsNothing) {
    dSetMessageHandler([](int number, const char *format, va_list arguments) {
        char text[200];
        std::vsnprintf(text, sizeof text, format, arguments);
        g_heard = std::to_string(number) + ": " + text;
    });
    testing::internal::CaptureStderr();
    dMessage(3, "%d %s", 4, "five");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(g_heard, "3: 4 five");
    dSetMessageHandler(nullptr);
}

}  // namespace
