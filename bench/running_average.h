// The thesis's way of measuring (ch. 3.3): the running average of the time of a frame is kept every
// 100 frames; mean and standard deviation are taken over the kept values; measuring ends when the
// running average has become stable.
#pragma once

#include "support/statistics.h"

#include <vector>

namespace bench {

class RunningAverage {
public:
    static constexpr int kFramesPerValue = 100;
    static constexpr std::size_t kValuesCompared = 10;

    // A batch of `frames` that took `seconds`. A value is kept at the end of the first batch at or
    // past each multiple of 100 frames.
    void add(int frames, double seconds);

    const std::vector<double> &kept() const { return m_kept; }  // s per frame

    // Mean and deviation of the kept values; before the first is kept, the average so far.
    support::MeanAndDeviation summary() const;

    // (largest - smallest) / mean of the last ten kept values; infinite while there are fewer.
    double relativeSpread() const;

private:
    long m_frames = 0;
    double m_seconds = 0;
    std::vector<double> m_kept;
};

}  // namespace bench
