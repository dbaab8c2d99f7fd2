// How long is measured: running averages of the time of a frame, when they are stable enough, and how many frames an engine runs at a
// time.
#pragma once

#include <string>
#include <vector>

#include "support/statistics.h"

namespace bench {

// The thesis's way of measuring (ch. 3.3): the running average of the time of a frame is kept every
// 100 frames; mean and standard deviation are taken over the kept values; measuring ends when the
// running average has become stable.
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

// When a world has been measured enough.
struct StoppingRule {
    double tolerance = 0.02;  // of RunningAverage::relativeSpread
    int minimumRounds = 30;   // so that the quartiles of the paired ratios mean something
    double minimumSeconds = 0;
    double maximumSeconds = 30;
    long maximumFrames = 100'000;

    enum class Verdict { GoOn, Stable, OutOfTime, OutOfFrames };

    // `averages`: one for each engine. `frames`: measured so far by each engine.
    Verdict judge(const std::vector<RunningAverage> &averages, int rounds, double seconds, long frames) const;
};

std::string toString(StoppingRule::Verdict verdict);

// Returns the number of frames that an engine runs before the next engine.
//
// Long enough that the clock and the change of process do not count, short enough that a change of
// the machine's mood falls on all engines alike: about 50 ms. The first frames of a batch find cold caches
// and sleeping workers, which those of a program that simulates without pause do not. Worlds of more than
// 10 ms a frame get five frames. No engine runs for more than two seconds, unless it takes longer for one
// frame.
//
// The result is 1, 2 or 5 times a power of ten, so that batches end at multiples of 100 frames,
// where the running averages are kept.
//
// `fastest`, `slowest`: seconds for a frame of the fastest and of the slowest engine.
int batchSize(double fastest, double slowest);

}  // namespace bench
