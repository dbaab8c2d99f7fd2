#include "core/dxLog.h"

#include <atomic>
#include <cstdarg>
#include <cstdio>
#include <cstring>

#include "core/dxEnvironment.h"
#include "core/dxGuards.h"

namespace {

constexpr const char *kLevelNames[] = {"error", "warning", "info", "debug"};

// Values of variables may have any characters: without control characters a line remains one line, and does not control the terminal. U+0080 to
// U+009f have two bytes.
void hideControls(char *text) {
    for (; *text != '\0'; ++text) {
        const auto byte = static_cast<unsigned char>(*text), next = static_cast<unsigned char>(text[1]);
        if (byte == 0xc2 && next >= 0x80 && next < 0xa0) text[0] = text[1] = '?';
        if (byte < 0x20 || byte == 0x7f) *text = '?';
    }
}

void write(dxLogLevel level, const char *text) {
    char line[1100];
    std::snprintf(line, sizeof line - 1, "ODE_MT %s: %s", kLevelNames[static_cast<int>(level)], text);
    hideControls(line);
    std::strcat(line, "\n");
    const dxNoCancellation whole;
    std::fputs(line, stderr);
}

constexpr int kUnread = -1;
std::atomic<int> shownLevel{kUnread};

void reportUnknown(const char *name) {
    char text[200];
    std::snprintf(text, sizeof text, "ODE_MT_LOG is '%.100s'; known: error, warning, info, debug", name);
    write(dxLogLevel::Warning, text);
}

// Takes no lock, which another thread might hold while this one forks: if several threads are first at the same
// time, all of them read the environment, and one of them reports.
void readEnvironment() {
    dxLogLevel level = dxLogLevel::Warning;
    const char *name = dxEnvironment(dxVariable::Log);
    const bool understood = name == nullptr || dxLogLevelFromName(name, level);
    int expected = kUnread;
    if (shownLevel.compare_exchange_strong(expected, static_cast<int>(level)) && !understood)
        reportUnknown(name);
}

}  // namespace

bool dxLogLevelFromName(const char *name, dxLogLevel &level) {
    for (int i = 0; i < 4; ++i) {
        if (std::strcmp(name, kLevelNames[i]) == 0) {
            level = static_cast<dxLogLevel>(i);
            return true;
        }
    }
    return false;
}

dxLogLevel dxGetLogLevel() {
    if (shownLevel.load(std::memory_order_relaxed) == kUnread) readEnvironment();
    return static_cast<dxLogLevel>(shownLevel.load(std::memory_order_relaxed));
}

void dxSetLogLevel(dxLogLevel level) { shownLevel.store(static_cast<int>(level), std::memory_order_relaxed); }

void dxLog(dxLogLevel level, const char *format, ...) {
    if (level > dxGetLogLevel()) return;
    char text[1001];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    write(level, text);
}
