#include "progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "support/text.h"

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

namespace {

// "4 worlds (a, b, c, d)".
std::string counted(const std::vector<std::string> &names, const char *thing) {
    std::string list;
    for (const std::string &name : names) list += (list.empty() ? "" : ", ") + support::printable(name);
    return std::to_string(names.size()) + ' ' + thing + (names.size() == 1 ? " (" : "s (") + list + ')';
}

// Of a part from 0 to 1.
std::string bar(double part) {
    constexpr int kWidth = 24;
    const int full = static_cast<int>(std::clamp(part, 0.0, 1.0) * kWidth);
    return '[' + std::string(static_cast<std::size_t>(full), '#') + std::string(static_cast<std::size_t>(kWidth - full), '-') + ']';
}

}  // namespace

Progress::Progress(std::size_t worlds, const StoppingRule &rule) : m_worlds(worlds), m_rule(rule) {}

void Progress::announce(const std::vector<std::string> &worlds, const std::vector<Engine> &engines) const {
    std::vector<std::string> names;
    for (const Engine &engine : engines) names.push_back(engine.name());
    std::fprintf(stderr, "%s on %s: at most %.0f s, warm-up not counted\n", counted(worlds, "world").c_str(), counted(names, "engine").c_str(),
                 static_cast<double>(m_worlds) * m_rule.maximumSeconds);
}

void Progress::showLoading(const std::string &world, const Engine &engine) {
    if (m_line.isDue()) m_line.show("loading " + support::printable(world) + " for " + support::printable(engine.name()));
}

void Progress::show(std::size_t world, const WorldResult &result) {
    if (!m_line.isDue()) return;
    const double left = std::max(0.0, static_cast<double>(m_worlds - world) * m_rule.maximumSeconds - result.seconds);
    const double part = 1 - left / (static_cast<double>(m_worlds) * m_rule.maximumSeconds);
    char seconds[32];
    std::snprintf(seconds, sizeof seconds, "%.0f", left);
    m_line.show((m_line.isOnTerminal() ? bar(part) + ' ' : "") + "at most " + seconds + " s left; world " + std::to_string(world + 1) + " of " +
                std::to_string(m_worlds) + ": " + support::printable(result.world) + ": " + std::to_string(result.frames) + " frames, " +
                std::to_string(result.rounds) + " rounds");
}

}  // namespace bench
