#include "progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace bench {

namespace {

constexpr std::chrono::milliseconds kTerminalInterval{200}, kLogInterval{5000};

}  // namespace

Progress::Progress(std::size_t worlds, const StoppingRule &rule)
    : m_worlds(worlds), m_rule(rule), m_isTerminal(isatty(STDERR_FILENO) != 0) {
    if (!m_isTerminal) m_next += kLogInterval;
}

void Progress::announce(std::size_t engines) const {
    std::fprintf(stderr, "%zu world%s on %zu engine%s: at most %.0f s, warm-up not counted\n", m_worlds, m_worlds == 1 ? "" : "s", engines,
                 engines == 1 ? "" : "s", static_cast<double>(m_worlds) * m_rule.maximumSeconds);
}

void Progress::show(std::size_t world, const WorldResult &result) {
    const Clock::time_point now = Clock::now();
    if (now < m_next) return;
    m_next = now + (m_isTerminal ? kTerminalInterval : kLogInterval);
    const double left = std::max(0.0, static_cast<double>(m_worlds - world) * m_rule.maximumSeconds - result.seconds);
    std::fprintf(stderr, "%sworld %zu of %zu: %s: %ld frames, %d rounds, %.0f of at most %.0f s; at most %.0f s left%s",
                 m_isTerminal ? "\r\033[K" : "", world + 1, m_worlds, result.world.c_str(), result.frames,
                 result.rounds, result.seconds, m_rule.maximumSeconds, left, m_isTerminal ? "" : "\n");
    std::fflush(stderr);
    m_isShown = m_isTerminal;
}

void Progress::clear() {
    if (!m_isShown) return;
    std::fputs("\r\033[K", stderr);
    std::fflush(stderr);
    m_isShown = false;
}

}  // namespace bench
