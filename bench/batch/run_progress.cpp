#include "batch/run_progress.h"

#include <cmath>
#include <cstdio>
#include <string>

namespace batch {

namespace {

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

RunProgress::RunProgress(long runs, long doneBefore, bool isQuiet) : m_runs(runs), m_isQuiet(isQuiet), m_done(doneBefore), m_doneBefore(doneBefore) {}

double RunProgress::elapsed() const { return std::chrono::duration<double>(Clock::now() - m_begin).count(); }

void RunProgress::show(std::size_t more) {
    m_done += static_cast<long>(more);
    if (m_isQuiet || !m_line.isDue()) return;
    const double rate = static_cast<double>(m_done - m_doneBefore) / elapsed();
    char aSecond[32];
    std::snprintf(aSecond, sizeof aSecond, "%.1f", rate);
    m_line.show(std::to_string(m_done) + " of " + std::to_string(m_runs) + " runs, " + aSecond + " a second, " +
                (rate > 0 ? duration(static_cast<double>(m_runs - m_done) / rate) + " left" : "time left unknown"));
}

void RunProgress::end() {
    if (m_isQuiet) return;
    m_line.clear();
    std::fprintf(stderr, "%ld runs in %s\n", m_done - m_doneBefore, duration(elapsed()).c_str());
}

}  // namespace batch
