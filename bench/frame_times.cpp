#include "frame_times.h"

#include <algorithm>
#include <cmath>

namespace bench {

namespace {

constexpr double kUnit = 1e-9;  // s: lower bound of bin 0, and what the clock resolves

}  // namespace

void FrameTimes::add(double seconds) {
    ++m_counts[static_cast<int>(std::floor(kBinsPerDoubling * std::log2(std::max(seconds, kUnit) / kUnit)))];
}

FrameTimes &FrameTimes::operator+=(const FrameTimes &other) {
    for (const auto &[bin, frames] : other.m_counts) m_counts[bin] += frames;
    return *this;
}

double FrameTimes::lowerBound(int bin) { return kUnit * std::exp2(static_cast<double>(bin) / kBinsPerDoubling); }

}  // namespace bench
