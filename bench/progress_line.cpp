#include "progress_line.h"

#include <unistd.h>

#include <cstdio>

namespace bench {

namespace {

constexpr std::chrono::milliseconds kTerminalInterval{200}, kLogInterval{5000};

}  // namespace

ProgressLine::ProgressLine() : m_isTerminal(isatty(STDERR_FILENO) != 0) {
    if (!m_isTerminal) m_next += kLogInterval;
}

bool ProgressLine::isDue() {
    const Clock::time_point now = Clock::now();
    if (now < m_next) return false;
    m_next = now + (m_isTerminal ? kTerminalInterval : kLogInterval);
    return true;
}

void ProgressLine::show(const std::string &text) {
    std::fprintf(stderr, "%s%s%s", m_isTerminal ? "\r\033[K" : "", text.c_str(), m_isTerminal ? "" : "\n");
    std::fflush(stderr);
    m_isShown = m_isTerminal;
}

void ProgressLine::clear() {
    if (!m_isShown) return;
    std::fputs("\r\033[K", stderr);
    std::fflush(stderr);
    m_isShown = false;
}

}  // namespace bench
