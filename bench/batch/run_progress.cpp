#include "batch/run_progress.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <string>

namespace batch {

namespace {

constexpr std::chrono::milliseconds kTerminalInterval{200}, kLogInterval{5000};

std::string duration(double seconds) {
    const long whole = std::lround(seconds);
    char text[64];
    if (whole >= 3600)
        std::snprintf(text, sizeof text, "%ld h %02ld min", whole / 3600, whole / 60 % 60);
    else if (whole >= 60)
        std::snprintf(text, sizeof text, "%ld min %02ld s", whole / 60, whole % 60);
    else
        std::snprintf(text, sizeof text, "%ld s", whole);
    return text;
}

}  // namespace

RunProgress::RunProgress(long runs, long doneBefore, bool isQuiet)
    : m_runs(runs), m_isQuiet(isQuiet), m_isTerminal(isatty(STDERR_FILENO) != 0), m_done(doneBefore), m_doneBefore(doneBefore) {
    if (!m_isTerminal) m_next += kLogInterval;
}

void RunProgress::print(const char *end) const {
    const double elapsed = std::chrono::duration<double>(Clock::now() - m_begin).count();
    const double rate = static_cast<double>(m_done - m_doneBefore) / elapsed;
    const std::string left = rate > 0 ? duration(static_cast<double>(m_runs - m_done) / rate) + " left" : "time left unknown";
    std::fprintf(stderr, "%s%ld of %ld runs, %.1f a second, %s%s", m_isTerminal ? "\r\033[K" : "", m_done, m_runs, rate, left.c_str(), end);
    std::fflush(stderr);
}

void RunProgress::show(std::size_t more) {
    m_done += static_cast<long>(more);
    if (m_isQuiet || Clock::now() < m_next) return;
    m_next = Clock::now() + (m_isTerminal ? kTerminalInterval : kLogInterval);
    print(m_isTerminal ? "" : "\n");
}

void RunProgress::end() {
    if (m_isQuiet) return;
    const double elapsed = std::chrono::duration<double>(Clock::now() - m_begin).count();
    std::fprintf(stderr, "%s%ld runs in %s\n", m_isTerminal ? "\r\033[K" : "", m_done - m_doneBefore, duration(elapsed).c_str());
}

}  // namespace batch
