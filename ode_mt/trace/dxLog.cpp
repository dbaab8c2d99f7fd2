#include "dxLog.h"

#include <atomic>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

constexpr const char *levelNames[] = {"error", "warning", "info", "debug"};

void write(dxLogLevel level, const char *text) {
    char line[1100];
    std::snprintf(line, sizeof line, "ODE_MT %s: %s\n", levelNames[static_cast<int>(level)], text);
    std::fputs(line, stderr);
}

dxLogLevel levelFromEnvironment() {
    dxLogLevel level = dxLogLevel::warning;
    const char *name = std::getenv("ODE_MT_LOG");
    if (name != nullptr && !dxLogLevelFromName(name, level)) {
        char text[200];
        std::snprintf(text, sizeof text, "ODE_MT_LOG is '%.100s'; known: error, warning, info, debug", name);
        write(dxLogLevel::warning, text);
    }
    return level;
}

std::atomic<dxLogLevel> &shownLevel() {
    static std::atomic<dxLogLevel> level{levelFromEnvironment()};
    return level;
}

}  // namespace

bool dxLogLevelFromName(const char *name, dxLogLevel &level) {
    for (int i = 0; i < 4; ++i) {
        if (std::strcmp(name, levelNames[i]) == 0) {
            level = static_cast<dxLogLevel>(i);
            return true;
        }
    }
    return false;
}

dxLogLevel dxGetLogLevel() { return shownLevel().load(std::memory_order_relaxed); }

void dxSetLogLevel(dxLogLevel level) { shownLevel().store(level, std::memory_order_relaxed); }

void dxLog(dxLogLevel level, const char *format, ...) {
    if (level > dxGetLogLevel()) return;
    char text[1001];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    write(level, text);
}
